// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/models/legendre_model.hpp>
#include <stagecraft/theory/statements/verdict.hpp>

namespace stagecraft::theory {

/// Whether two methods on the same nodes, with the same weights, are a symplectic pair:
/// b_i A_hat_ij + b_j A_ji = b_i b_j for all i, j (Hairer-Lubich-Wanner, section VI.4, Theorem 4.6). With
/// <u, v> = b^T(u v) that is <u, A_hat v> + <A u, v> = (b^T u)(b^T v) for all u and v; in Legendre coordinates
/// G A_hat + (G A)^T = e_0 e_0^T, exact for every s, O(s) entries for Lobatto IIIA-IIIB. Throws
/// std::invalid_argument where the nodes differ.
verdict symplectic_pair(const legendre_model<tableaux::rational>& first,
                        const legendre_model<tableaux::rational>& second);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/stability/symplectic_pair-inl.hpp"
#endif
