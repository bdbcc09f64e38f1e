// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <filesystem>
#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/tableaux/reading.hpp>
#include <string>
#include <string_view>
#include <variant>

namespace stagecraft::tableaux {

/// Largest order that a method of several tableaux may claim: with two colours there are 1202 conditions up
/// to 6. Rosenbrock methods have 200 up to 8. Nystrom trees are fewer, 3307 up to order 13 of y'' = f(t, y), 65,276 up to order 10 of y'' = f(t, y, y').
inline constexpr int largest_coupled_order = 6;
constexpr int largest_order_of(const partitioned_file& file) {
    if (file.coupling == coupling::rosenbrock) return 8;
    if (file.coupling != coupling::nystrom) return largest_coupled_order;
    return file.uses_velocity ? 10 : 13;
}
/// Largest orders that a Rosenbrock method may claim with an arbitrary matrix (498 conditions) and of index 1.
inline constexpr int largest_w_order = 7, largest_index_1_order = 6;
/// Most tableaux of one method.
inline constexpr int most_partners = 4;

namespace json_reader {

struct document;

partitioned_file partitioned(const document& d, const reading& how, const std::filesystem::path& folder);

}  // namespace json_reader

/// A tableau, or a method of several.
using method_file = std::variant<tableau_file, partitioned_file>;

/// Reads a tableau as read_tableau does, or a method of several: {"form", "partners":[...], "claims":{...}}
/// with form "additive", "partitioned" or "separable" and partners that are tableaux or names of files,
/// relative to `folder`; or {"form":"nystrom", "c", "A_bar", "b_bar", "b", "A", "b_bar_embedded",
/// "b_embedded", "claims"}, A only where f depends on y'; or a Rosenbrock method as rosenbrock() of read_rosenbrock.hpp says. Throws unusable_input as read_tableau.
method_file read_method_text(std::string_view text, const reading& how = {},
                             const std::filesystem::path& folder = ".");

/// Reads the file at `path` (text_of_file). Throws unusable_input that names it.
method_file read_method_file(const std::string& path, const reading& how = {});

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/read_partitioned-inl.hpp"
#endif
