// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/small_solve.hpp"
#include "stagecraft/theory/dynamics/multinomial.hpp"

namespace stagecraft::theory::detail {

using tableaux::dense;

/// Whether p is proved to be a sum of squares: p = z^T S z with z the monomials of half the exponents of p's
/// and S its coefficients, shared evenly among the products that give a monomial; decided for this S by L D
/// L^T. False says nothing.
bool is_sum_of_squares(const multinomial& p, int unknowns);

}  // namespace stagecraft::theory::detail

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/sum_of_squares-inl.hpp"
#endif
