// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/theory/stability/stability_function.hpp>
#include <string>
#include <vector>

namespace stagecraft::theory {

/// Weights for the stages of a collocation method, by their moments: sum_i b_i c_i^k = moments[k] for k < s. Distinct nodes
/// have exactly one set of weights with given moments, and these are rational where the weights are not. By C(s) the
/// order of the weights is q < s exactly where moments[k] = 1/(k + 1) for k < q (Hairer-Wanner II, Theorem IV.5.1).
struct embedded_weights_of_nodes {
    std::vector<tableaux::rational> moments;
    /// The weight of f(t_0, y_0), an explicit stage before the others, where it is used.
    std::optional<tableaux::rational> at_zero;
    int order = 0;    ///< proved; of `highest` beyond s "at least"
    std::string why;  ///< one sentence: what was chosen
};

/// The embedded formula on the stages and f(t_0, y_0) that has the highest order of those that differ from the method.
///
/// The s + 1 nodes 0, c_1, ..., c_s have one quadrature formula of order s + 1. If the method itself has order s only, that
/// formula differs from it and is taken: its weight at 0 is the integral of w over w(0). If the method has order s + 1 or
/// more, it *is* that formula, and what differs from it has order s at most: b + g (delta_0 - E), where E extrapolates
/// from the nodes to 0 and g is any number, as in the code RADAU5 (Hairer-Wanner II, formula IV.8.19). There g is the real
/// eigenvalue of A, which is irrational; here it is 1/m, nearest to the geometric mean of the eigenvalues that are not 0.
/// (g scales the estimate, and no more.) If 0 is a node, f(t_0, y_0) is the first stage already: E then extrapolates
/// from the other s - 1 nodes, and the order is s - 1. Nothing where there are no such weights: the explicit Euler method.
/// Exact; O(s^2).
std::optional<embedded_weights_of_nodes> highest_embedded(const tableaux::nodal_polynomial& w);

/// What was found of L-stable formulas: one of them, or why there is none.
struct l_stable_embedded_formula {
    std::optional<embedded_weights_of_nodes> weights;
    std::string none;  ///< one sentence, empty where there is one
};

/// Weights for the stages of the method, other than its own, with an L-stable stability function.
///
/// f(t_0, y_0) is of no use here: its weight would make R(infinity) infinite. Let d be the degree of Q = det(I - zA), the number of
/// nodes that are not 0. L-stability needs P of degree d - 1 at most, so an order d - 1 leaves one formula: P is the
/// beginning of Q e^z. If that is the method itself or is not L-stable, the formulas of order d - 2 are looked at: one
/// coefficient tau of P is free. |P(iy)| <= |Q(iy)| holds for all y on an interval of tau; the rational number with the
/// least denominator in its middle third is taken, and L-stability is then decided exactly. That the interval is empty is
/// proved by a number t and two values of y, one of which excludes all tau >= t and the other all tau <= t. Lower orders are
/// not looked at. Throws undecided where the interval is neither found nor proved empty.
l_stable_embedded_formula l_stable_embedded(const tableaux::nodal_polynomial& w);

/// The stability function of weights for the stages: P = Q + sum_j z^j L(M^(s-j+1)) over Q = det(I - zA), where M = w/s!
/// and L takes x^k to moments[k] (from Hairer-Wanner II, Theorem IV.3.10). Not in lowest terms.
stability_function<tableaux::rational> function_of_moments(const tableaux::nodal_polynomial& w,
                                                           const std::vector<tableaux::rational>& moments);

/// The weights themselves at increasing nodes, exactly or as enclosures.
tableaux::column<tableaux::quadratic> weights_at(const std::vector<tableaux::rational>& moments,
                                                 const std::vector<tableaux::quadratic>& nodes);
std::vector<tableaux::ball> weights_at(const std::vector<tableaux::rational>& moments,
                                       const std::vector<tableaux::ball>& nodes, int bits);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/stability/embedded_collocation-inl.hpp"
#endif
