// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/claims.hpp>
#include <stagecraft/tableaux/reading.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>
#include <string_view>

namespace stagecraft::tableaux {

namespace json_reader {

struct document;

tableaux::claims read_claims(const document& d);

/// Throws where the document claims what only Rosenbrock methods have.
void reject_rosenbrock_claims(const document& d);
void reject_single_claims(const document& d);

/// The tableau that a document holds, as read_tableau.
tableau_file tableau(const document& d, const reading& how);

}  // namespace json_reader

/// Reads a tableau from JSON text (nlohmann-json is needed where this is compiled):
/// {"name","source","note","c":[...],"A":[[...]],"b":[...],"b_embedded":[...],"b_theta":[[...]],"claims":{...}}, with A and b
/// required; or what the command prints as JSON, where the tableau stands under "tableau", or has "family",
/// "stages" and "digits" besides; or {"form", ...} of from_stage_form. Entries are strings as in read_entry, or JSON numbers: integers are exact, others are doubles.
/// `how` says what decimals mean. Throws unusable_input, one line naming line and entry: bad JSON, a missing, repeated or unknown key, wrong
/// sizes, and whatever read_entry refuses.
tableau_file read_tableau(std::string_view text, const reading& how = {});

/// The text of a file, "-" for standard input. Throws unusable_input that names it where it cannot be read,
/// and for pipes and devices, which might block or never end.
std::string text_of_file(const std::string& path);

/// Reads the file at `path` (text_of_file). Throws unusable_input that names it.
tableau_file read_tableau_file(const std::string& path, const reading& how = {});

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/read-inl.hpp"
#endif
