// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/polynomial.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <string_view>

namespace stagecraft::tableaux {

/// Largest degree that read_polynomial accepts.
inline constexpr int largest_degree = 64;

/// Reads a polynomial in x with rational coefficients: "x^3-9/5*x^2+9/10*x-1/10" or any expression in x and
/// exact numbers that is one, "(x-1)*(5*x^2-5*x+1)". Throws std::invalid_argument: what read_entry refuses,
/// decimals, division by a polynomial, an irrational coefficient, a degree above largest_degree.
polynomial<rational> read_polynomial(std::string_view text);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/polynomial_text-inl.hpp"
#endif
