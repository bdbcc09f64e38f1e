// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <vector>

#include "stagecraft/tableaux/exact_collocation.hpp"
#include "stagecraft/tableaux/quadratic.hpp"

namespace stagecraft::tableaux {

/// The roots of a rational polynomial, increasing, where they are distinct, real, and all rational but at
/// most one pair of quadratic surds; nothing otherwise (roots() and the Legendre model serve the rest). A
/// rational root times the leading integer coefficient is an integer: one candidate per isolated root. Throws
/// std::domain_error for the zero polynomial.
std::optional<std::vector<quadratic>> roots_in_quadratic_field(const polynomial<rational>& p);

/// The collocation method on the roots of a rational polynomial, such as x^3 - 9/5 x^2 + 9/10 x - 1/10.
/// Throws std::invalid_argument where the roots are not real, distinct and in one quadratic field.
constructed<quadratic> collocation(const polynomial<rational>& w);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/quadratic_roots-inl.hpp"
#endif
