// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>

namespace stagecraft::tableaux {

/// Adds what is claimed, where anything is, as "claims".
void add_claims(const claims& stated, nlohmann::ordered_json& j);

/// The file as JSON that read_tableau reads: every entry as the text it was written in.
nlohmann::ordered_json to_json(const tableau_file& file);
/// The same for read_method_text.
nlohmann::ordered_json to_json(const partitioned_file& file);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/tableau_json-inl.hpp"
#endif
