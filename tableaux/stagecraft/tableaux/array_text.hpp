// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include "stagecraft/tableaux/array_value.hpp"
#include "stagecraft/tableaux/program_tokens.hpp"

namespace stagecraft::tableaux::program_text {

/// What a name stands for, or an element ("b[0]", "A[1][0]"), if it is known; who asks uses it.
using lookup = std::function<const value*(const std::string& name)>;

/// The value that tokens [begin, end) stand for: numbers with + - * / and powers, roots, fractions as calls of two
/// numbers; arrays in any of the notations of tokens_of, also with factors, sums and transpositions, and in the calls,
/// wrappers and methods that program_calls.hpp lists. Throws not_understood where there is anything else. Linear in the tokens.
value value_of(const std::vector<token>& tokens, std::size_t begin, std::size_t end, const lookup& known);

/// The array of the numbers in tokens [begin, end), which commas separate; "3*0.0" of Fortran's DATA stands three times.
value list_of(const std::vector<token>& tokens, std::size_t begin, std::size_t end, const lookup& known);

/// The last part of "np.array", "sp::Rational".
std::string_view last_part(std::string_view name);

}  // namespace stagecraft::tableaux::program_text

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/array_text-inl.hpp"
#endif
