// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/statements/verdict.hpp>
#include <vector>

/// Stability, symmetry and the like for tableaux known by enclosures only. An enclosure contains methods with
/// and without such a property (they are equalities, or inequalities that hold with equality at order p), so
/// nothing is proved here; what no method in the enclosure can have is refuted, with a witness.

namespace stagecraft::theory {

using tableaux::ball;
using tableaux::bound;

inline constexpr const char* data_reason = "the entries are known by enclosures";

namespace detail {

inline double middle(const ball& x) { return static_cast<double>(x.middle().to<bound>()); }

Eigen::MatrixXd middle(const Eigen::Matrix<ball, -1, -1>& m);

/// A double, exactly.
ball exactly(double x);

/// Coefficients of det(I - zA), ascending, by the recursion of Faddeev and Leverrier.
std::vector<ball> determinant_of_one_minus_z(const Eigen::Matrix<ball, -1, -1>& A);

/// P and Q of R = P/Q, both of formal degree s.
struct enclosed_stability_function {
    std::vector<ball> numerator;
    std::vector<ball> denominator;
};

/// P = Q (1 + sum_j b^T A^{j-1} 1 z^j), cut off at degree s: the moments b^T A^{j-1} 1 are close to 1/j! and
/// widen far less than det(I - z (A - 1 b^T)) does.
enclosed_stability_function stability_function_of(const tableau<ball>& t);

/// The degree of Q, at most: the number of stages that are left when those are taken away one by one that depend on none
/// of those left, themselves included (an explicit first stage, say), or that none of them depends on.
std::size_t most_implicit_stages(const tableau<ball>& t);

ball at(const std::vector<ball>& p, const ball& x);

}  // namespace detail

/// The last row of A against b.
verdict rounded_stiffly_accurate(const subject<ball>& s);

/// M = 0; necessary for irreducible methods only.
verdict rounded_symplectic(const subject<ball>& s);

/// b_sigma(i) = b_i, a_ij + a_sigma(i)sigma(j) = b_j for the numbering sigma with c_i + c_sigma(i) = 1, where
/// the nodes determine it.
verdict rounded_symmetric(const subject<ball>& s);

/// b >= 0 and M >= 0: refuted by a negative weight or by a vector v with v^T M v < 0, tried for the lowest
/// eigenvector of the middle of M. The residual is how far below 0 the middle of v^T M v lies.
verdict rounded_algebraically_stable(const subject<ball>& s);

/// |R(z)| <= 1 for Re z <= 0: refuted for explicit methods, and by a z on the imaginary or the negative real
/// axis with |R(z)| > 1 for certain, of a grid of 401 points from 1e-4 to 1e4 on each. What is left is
/// measured by the largest |R(iy)|^2 - 1 of the middle on the grid.
verdict rounded_a_stable(const subject<ball>& s);

/// A-stable with R(infinity) = 0, that is degree P < degree Q.
verdict rounded_l_stable(const subject<ball>& s);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/rounded_properties-inl.hpp"
#endif
