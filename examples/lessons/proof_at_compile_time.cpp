// SPDX-License-Identifier: BSL-1.0
// A certificate at compile time: where one number below is wrong, this file does not compile.
#include <iostream>
#include <stagecraft/tableaux/fixed_rational.hpp>
#include <stagecraft/theory/models/legendre_model.hpp>
#include <stagecraft/theory/models/legendre_simplifying.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/stability/algebraic_stability.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>

using namespace stagecraft::theory;
using stagecraft::tableaux::family;
using Q = stagecraft::tableaux::fixed_rational;  // a fraction that refuses to overflow

// The classical method of order 4 as it stands in the books: A, b, c.
constexpr matrix_model rk4(
    std::array<std::array<Q, 4>, 4>{{{Q(0)}, {Q(1, 2)}, {Q(0), Q(1, 2)}, {Q(0), Q(0), Q(1)}}},
    std::array<Q, 4>{Q(1, 6), Q(1, 3), Q(1, 3), Q(1, 6)}, std::array<Q, 4>{Q(0), Q(1, 2), Q(1, 2), Q(1)});
static_assert(has_order<4>(rk4), "all 8 conditions hold");
static_assert(!has_order<5>(rk4), "and one of order 5 does not");

// Radau IIA with 50 stages, whose nodes nobody writes down: B(99), C(50), D(49) from its nodal polynomial.
static_assert(simplifying_of(legendre_model<Q>(family::radau_iia, 50)) == simplifying{99, 50, 49});
static_assert(is_algebraically_stable(legendre_model<Q>(family::radau_iia, 50)));
static_assert(!is_algebraically_stable(legendre_model<Q>(family::lobatto_iiia, 5)));

int main() { std::cout << "proved by the compiler\n"; }
