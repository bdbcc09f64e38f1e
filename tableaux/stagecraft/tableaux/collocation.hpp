// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <vector>

namespace stagecraft::tableaux {

/// The Lagrange polynomial of a node: factor times the sum over k of shape[k] P_k.
struct lagrange_form {
    ball factor;
    std::vector<ball> shape;
};

/// The Lagrange polynomials of all nodes; p holds the values P_k(c_j), k <= s. For a family: shape[k] =
/// P_k(c_j) / G_k with the Gram entries G_k = 1/(2k+1) of b^T(uv), the last one 1/(s-1) for Lobatto, and
/// factor = b_j = 1 / sum P_k(c_j)^2 / G_k. For other nodes: w / (x - c_j) by back substitution in the
/// three-term recurrence, scaled to 1 at c_j. O(s^2).
std::vector<lagrange_form> lagrange_forms(const nodal_polynomial& w, const std::vector<ball>& nodes,
                                          const std::vector<std::vector<ball>>& p, int bits);

/// Whether the nodes are symmetric about 1/2: w has then Legendre coordinates of one parity alone.
bool symmetric_nodes(const nodal_polynomial& w);

/// Enclosures of c, b and A of the method with nodal polynomial w and the given construction (Hairer-Wanner
/// II.IV.5), by closed forms and computed with `bits` bits: with I_k the integral of P_k from 0 to x
/// and l_j = factor_j sum over k of shape_j[k] P_k,
///     collocation   a_ij = factor_j sum over k of I_k(c_i) shape_j[k]
///     adjoint       a_ij = b_j (1 - sum over k of I_k(c_j) shape_i[k] / shape_i[0]),    that is D(s)
///     lobatto_iiic  as collocation, with (P_{s-1} - P_{s-2}) / (2(s-1)) in the place of I_{s-1}
/// Radii grow like a power of s for a family, by about 1.3 bits a stage for other nodes. s^3 multiplications,
/// half of them where symmetry gives half of the rows. Throws undecided where `bits` is too small.
tableau<ball> enclose(const nodal_polynomial& w, construction rule, int bits);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/collocation-inl.hpp"
#endif
