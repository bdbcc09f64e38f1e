// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::tableaux {

/// A file and the name of the function that is to return what it holds.
using named_pair = std::pair<std::string, partitioned_file>;

/// A header of include/stagecraft/coefficients/: of each additive, partitioned, separable or Nystrom method a function of
/// its name, with the nearest doubles as constexpr arrays. `command` stands in the first line. Throws std::invalid_argument for
/// methods of more than two tableaux and names that are none in C++.
std::string pairs_header(const std::vector<named_pair>& methods, const std::string& command);

using named_tableau = std::pair<std::string, tableau_file>;

/// The same of files of one tableau: of each a function that returns a tableau<Scalar, stages>, or, where all give their
/// registers, a low_storage_method<Scalar>, where all have b_theta, a dense_method<Scalar, stages>, whose name ends in
/// _dense. Tableaux beside methods with b_theta are those of coefficients/explicit.hpp: they are not written again, and a
/// method that is one of them, to the bit, takes its arrays from there.
std::string methods_header(const std::vector<named_tableau>& methods, const std::string& command);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/emit_pairs-inl.hpp"
#endif
