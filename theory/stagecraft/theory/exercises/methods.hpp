// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "stagecraft/tableau.hpp"
#include "stagecraft/theory/exercises/dice.hpp"

// Methods with rational coefficients for exercises.

namespace stagecraft::theory::exercise_methods {

using method = tableau<rational>;

/// A zero tableau with the given nodes.
method with_nodes(const std::vector<rational>& c);

/// Row i of A from a_i2 on as given; a_i1 makes the row sum c_i.
void set_row(method& t, Eigen::Index i, const std::vector<rational>& from_second);

/// Weights with sum b_i c_i^k = 1/(k + 1) for k < s, distinct nodes.
void set_interpolatory_weights(method& t);

/// Two distinct nodes in (0, 1], the first of them not 2/3.
std::pair<rational, rational> two_nodes(dice& d);

/// Explicit, two stages, order 2: b_2 c_2 = 1/2.
method explicit_2(dice& d);

/// Explicit, three stages, order 3: interpolatory weights and b_3 a_32 c_2 = 1/6.
method explicit_3(dice& d);

/// Explicit, four stages, order 4, nodes 0, u, v, 1: interpolatory weights, D(1) and b^T(c A c) = 1/8
/// (Hairer-Norsett-Wanner I.II.1); nothing for nodes that allow none.
std::optional<method> explicit_4(const rational& u, const rational& v);
method explicit_4(dice& d);

/// Singly diagonally implicit, two stages, nodes g and 1 - g: order 2, and order 3 for no rational g.
method sdirk_2(const rational& g);

/// Collocation at distinct nodes: integrals of their Lagrange polynomials, from the moments of each row.
method collocation(const std::vector<rational>& nodes);

/// Distinct nodes in [0, 1], increasing: two, or three at times; at times two with order 3.
std::vector<rational> collocation_nodes(dice& d);

}  // namespace stagecraft::theory::exercise_methods

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/methods-inl.hpp"
#endif
