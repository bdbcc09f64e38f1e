// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <string>
#include <vector>

/// The stability function of a tableau known by enclosures: of every tableau among them.

namespace stagecraft::theory {

using tableaux::ball;
using tableaux::bound;

/// An equality is taken to hold, and told, that the digits show to this part of its sides.
inline constexpr bound equality_level = 1e-3L;

/// P and Q of R = P/Q, coefficients ascending, both of formal degree s; Q(0) = P(0) = 1.
struct enclosed_stability_function {
    std::vector<ball> numerator;
    std::vector<ball> denominator;
    std::size_t degree = 0;  ///< of Q, at most: coefficients beyond are exactly 0

    /// Largest part of P beyond the degree of Q: what it is, and what is not known of it.
    bound excess = 0, excess_bound = 0;
    /// Whether R is certainly infinite at infinity.
    bool unbounded() const;
    /// The same with P of the degree of Q, as methods mean it whose P is beyond only by the rounding of their digits.
    enclosed_stability_function trimmed() const;
};

/// P = Q (1 + sum_j b^T A^{j-1} 1 z^j), cut off at degree s, or det(I - z (A - 1 b^T)) by the mean value theorem, whichever
/// is narrower. Q is the product of the 1 - a_ii z where A is lower triangular.
enclosed_stability_function stability_function_of(const subject<ball>& s);

/// The largest p with R(z) = e^z + O(z^{p+1}) as far as the digits tell: no coefficient of Q(z) e^z - P(z) up to z^p
/// is certainly not 0, and each is known to equality_level.
struct exponential_order {
    int order = 0;
    bound residual = 0;  ///< the largest of these coefficients
    bound bound_on_it = 0;
};
exponential_order exponential_order_of(const enclosed_stability_function& f);

/// |Q(iy)|^2 - |P(iy)|^2 as a polynomial in y^2, the first `leave_out` coefficients taken as 0.
std::vector<ball> margin_on_axis(const enclosed_stability_function& f, int leave_out = 0);
/// |Q|^2 - |P|^2 at z = -t e^{i alpha} as a polynomial in t; u = cos(alpha).
std::vector<ball> margin_on_ray(const enclosed_stability_function& f, const ball& u);
/// |Q(iy)|^2 as a polynomial in y^2.
std::vector<ball> denominator_on_axis(const enclosed_stability_function& f);

/// Whether P(z) = Q(-z) or -Q(-z) as far as the digits tell, each coefficient known to rounding_level, as of symmetric
/// methods: |R(iy)| = 1 then. R(infinity) would be the sign, 1 or -1; 0: no.
struct unitary_function {
    int at_infinity = 0;
    bound residual = 0, bound_on_it = 0;
};
unitary_function unitary_of(const enclosed_stability_function& f);

/// R(infinity) of every tableau among the enclosures: 1 - b^T A^{-1} 1 by an approximate inverse and the bound that its
/// residual gives; where A is singular by its zeros, the quotient of the leading coefficients. Nothing where that is not
/// certainly bounded.
std::optional<ball> value_at_infinity(const subject<ball>& s, const enclosed_stability_function& f);

namespace detail {

using ball_matrix = Eigen::Matrix<ball, -1, -1>;

/// A double, exactly; a power of two not below a bound that is not 0.
ball exactly(double x);
ball exactly_above(bound x);

inline double middle(const ball& x) { return static_cast<double>(x.middle().to<bound>()); }

Eigen::MatrixXd middle(const Eigen::Matrix<ball, -1, -1>& m);

/// Coefficients of det(I - zA), ascending, by the recursion of Faddeev and Leverrier and the mean value theorem.
std::vector<ball> determinant_of_one_minus_z(const Eigen::Matrix<ball, -1, -1>& A);

/// A without the rows and columns i of which one vanishes exactly: each brings the eigenvalue 0.
Eigen::Matrix<ball, -1, -1> without_zero_lines(const Eigen::Matrix<ball, -1, -1>& A);

}  // namespace detail

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/enclosed_function-inl.hpp"
#endif
