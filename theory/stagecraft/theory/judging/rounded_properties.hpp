// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/statements/verdict.hpp>

/// Stability, symmetry and the like for tableaux known by enclosures only. An enclosure contains methods with
/// and without such a property (they are equalities, or inequalities that hold with equality at order p), so
/// nothing is proved here; what no method in the enclosure can have is refuted, with a witness.

namespace stagecraft::theory {

using tableaux::ball;
using tableaux::bound;

inline constexpr const char* data_reason = "the entries are known by enclosures";

/// The last row of A against b.
verdict rounded_stiffly_accurate(const subject<ball>& s);

/// M = 0; necessary for irreducible methods only.
verdict rounded_symplectic(const subject<ball>& s);

/// b_sigma(i) = b_i, a_ij + a_sigma(i)sigma(j) = b_j for the numbering sigma with c_i + c_sigma(i) = 1, where
/// the nodes determine it.
verdict rounded_symmetric(const subject<ball>& s);

/// b >= 0 and M >= 0: refuted by a negative weight or by a vector v with v^T M v < 0, tried for the lowest
/// eigenvector of the middle of M. Else M + epsilon I is certainly positive definite, by the pivots of its LDL^T, for
/// the least epsilon found, which is the bound; the residual is how far below 0 the middle of v^T M v lies.
verdict rounded_algebraically_stable(const subject<ball>& s);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/rounded_properties-inl.hpp"
#endif
