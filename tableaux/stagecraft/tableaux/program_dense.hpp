// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>
#include "stagecraft/tableaux/program_groups.hpp"

/// The dense output beside a program's tableau.

namespace stagecraft::tableaux::program_text {

/// Gives each group that has none yet the array with a name of `dense_words` that stands in its scope, or anywhere where the program
/// has one tableau, and that has as many rows or weights as there are stages, or one more. Marks what it uses of v.
void take_dense(groups& out, variables& v);

/// b_theta of a file from the array of a group, one row for each stage, where b and the number of stages are those of the tableau.
/// Weights at theta = 1/2 make the polynomial of degree 4 that has them there, b at 1, and the slopes of the first and the last stage
/// at both ends (Shampine 1986). Nothing where the group has no dense output.
std::vector<std::vector<cell>> dense_of(const group& g, const variables& v, const std::vector<cell>& b);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/program_dense-inl.hpp"
#endif
