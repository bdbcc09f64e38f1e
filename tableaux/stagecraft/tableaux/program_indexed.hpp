// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include "stagecraft/tableaux/program_variables.hpp"

/// Programs that give each coefficient, or each row, a name of its own.

namespace stagecraft::tableaux::program_text {

/// "a21" is "a" with 2 and 1, "b10_3" is "b" with 10 and 3, "c12" is "c" with 12.
struct indexed_name {
    std::string stem;
    std::vector<std::string> index;  ///< one or two, as written: "21" is one that may stand for two
};

/// Nothing where the name has no index, or where its stem does not end with a word for coefficients.
std::optional<indexed_name> indexed(std::string_view name);

/// Adds to v an array for each stem: of numbers (c1, c2, ...), of numbers with two indices (a21, a31, a32, ...: "a21" is two
/// indices where no number of the stem has one digit; of three digits the first two are the row, of four also the last two
/// the column), or of rows (b3, b4, ... where these are arrays). Indices count from 0 where any of a scope is 0. A name that
/// comes again begins the next arrays. What is gathered is used where its array is.
void gather_indexed(variables& v);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_indexed-inl.hpp"
#endif
