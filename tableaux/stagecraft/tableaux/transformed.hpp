// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/complex_ball.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/polynomial.hpp>
#include <vector>

namespace stagecraft::tableaux {

/// What A^-1 is, D being differentiation of the polynomial of degree < s through s values at the nodes:
///     collocation, c_1 > 0      A^-1 v holds the derivatives of the polynomial of degree s with values v
///                               at the nodes and 0 at 0
///     first_column, c_1 = 0     A^-1 = D + e_1 e_1^T / b_1, for A maps e_1 to b_1 (1, ..., 1)^T and
///                               integrates up to degree s-2 (Lobatto IIIC, Radau IA)
enum class inverse_form { collocation, first_column };

/// The form that holds for a method, or std::invalid_argument, saying why, where A is singular.
inverse_form inverse_form_of(const nodal_polynomial& w, construction rule);

/// The weight of the node 0 where c_1 = 0, exactly: the integral of w / (x w'(0)).
rational first_weight(const nodal_polynomial& w);

/// The characteristic polynomial of A^-1 up to a factor, exactly. Collocation: the sum over k of w^(k)(0)
/// z^{s-k} (Hairer-Wanner II, theorem IV.3.10); first column: with g = w / x, b_1 g(0) z^s minus the sum
/// over k < s of g^(k)(0) z^{s-1-k}.
polynomial<rational> characteristic_polynomial(const nodal_polynomial& w, inverse_form form);

/// Whether w'' vanishes at every node but 0 and 1, exactly: w'' is then a multiple of w / (x (x - 1)). So it
/// is for Lobatto nodes, whose w solves x (x - 1) w'' = s (s - 1) w; the entries of A^-1 that are 0 for this
/// reason would stay undecided at any precision.
bool curvature_vanishes_inside(const nodal_polynomial& w);

/// A^-1 by its closed form: with d_ij = w'(c_i) / (w'(c_j) (c_i - c_j)) and d_jj = w''(c_j) / (2 w'(c_j)), it
/// is d_ij c_i / c_j + delta_ij / c_j for collocation, d_ij + delta_i1 delta_j1 / b_1 for the first column.
tableau<ball>::matrix enclose_inverse(const nodal_polynomial& w, inverse_form form, const tableau<ball>& t,
                                      int bits);

/// Eigenvector of A^-1 for lambda, scaled so that its last component is 1: the values at the nodes of the sum
/// over k of lambda^{-k} g^(k), g = w' for collocation and w / x for the first column. Its Legendre
/// coordinates V solve V - V' / lambda = g: with q those of V',
///     V_k = g_k + q_k / lambda,   q_{k-1} = 2 (2k-1) (V_k + q_{k+1} / (2 (2k+3))).
/// Throws undecided unless the last component is proved to be non-zero.
std::vector<complex_ball> enclose_eigenvector(const std::vector<ball>& g,
                                              const std::vector<std::vector<ball>>& p,
                                              const complex_ball& lambda);

/// Inverse of a matrix of enclosures by elimination with row pivots: it encloses the inverse of every matrix
/// within. O(n^3). Throws undecided where a pivot contains 0.
tableau<ball>::matrix enclose_inverse(tableau<ball>::matrix m);

/// Whether the real part of the first component of the complex eigenvector vanishes for s = 2, exactly: the
/// two diagonal entries of A^-1 are then equal. (Gauss and Lobatto IIIC with two stages; it would stay
/// undecided at any precision.)
bool first_component_is_imaginary(const nodal_polynomial& w, inverse_form form);

/// Enclosures of everything a transformed_tableau holds (layout and scaling there). Throws
/// std::invalid_argument where A is singular, undecided where `bits` is too small.
transformed_tableau<ball> enclose_transformed(const nodal_polynomial& w, construction rule, int bits);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/transformed-inl.hpp"
#endif
