// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/reading.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>

/// Explicit methods as codes for partial differential equations store them: by what a step overwrites.

namespace stagecraft::tableaux {

namespace json_reader {

struct document;

/// Whether a "form" is one of a single tableau.
bool is_stage_form(const std::string& form);

/// {"form":"shu-osher","alpha","beta"}, {"form":"2N","A","B"}, {"form":"2S","gamma1","gamma2","delta","beta"} or
/// {"form":"3S*","gamma1","gamma2","gamma3","delta","beta"}, and "b_embedded" where there is one, as a tableau, whose c are
/// the row sums (registers_of).
tableau_file from_stage_form(const document& d, const reading& how);

}  // namespace json_reader

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/stage_forms-inl.hpp"
#endif
