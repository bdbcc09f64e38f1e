// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/inner_product.hpp"
#include "stagecraft/theory/dynamics/maximum.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// The least gamma of the one-sided Lipschitz condition <f(x) - f(y), x - y> <= gamma |x - y|^2 (lecture,
/// Definition 1.4): the supremum of the logarithmic norm of f' (Hairer-Norsett-Wanner I, section I.10).
/// proved: low <= gamma <= high, both proved, low = high where it is known exactly; high may be used as a
/// constant. refuted: there is none; `refuting_pair` gives points for every gamma. consistent: the search
/// ended early, gamma >= low is all that is proved.
struct one_sided_constant {
    theory::verdict verdict;
    rational low, high;
    std::vector<rational>
        point;  ///< where the logarithmic norm of f' is at least low, or near such a point if that is not
                ///< rational (the verdict says "near"); empty: at infinity
};

namespace detail {

std::string text(const std::vector<rational>& x);

one_sided_constant found(const std::string& where, supremum s, std::vector<rational> point,
                         bool exactly = true);

/// The Jacobian of polynomials.
template <int N>
dense<multinomial> jacobian(const state<multinomial, N>& f) {
    dense<multinomial> J(N, N);
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) J(i, j) = f[i].derivative(j);
    return J;
}

/// The matrices of a symmetric matrix of polynomials, monomial by monomial.
std::map<multinomial::monomial, dense<rational>> by_monomial(const dense<multinomial>& S);

}  // namespace detail

/// On the whole line, f rational: decided (Sturm). Throws std::invalid_argument where f divides through zero.
template <int N, class F>
requires(N == 1) one_sided_constant one_sided_lipschitz(F&& f) {
    const auto slope = derivative(as_rational_function(f));
    const auto s = supremum_on_line(slope);
    if (!s) return {verdict::refuted("f' is unbounded above: no gamma exists"), 0, 0, {}};
    if (!s->point) return detail::found("on R", *s, {});
    return detail::found("on R", *s, {*s->point}, !(slope(*s->point) < s->low));
}

/// On R^N, f polynomial, in the inner product x^T G y. Decided where f' is constant, or where every other
/// part of its symmetric part is an even monomial times a negative semidefinite matrix, so that the largest
/// value is that at 0; consistent else: give a box.
template <int N, class F>
requires(N > 1) one_sided_constant one_sided_lipschitz(F&& f, const dense<rational>& G = euclidean(N)) {
    require_inner_product(G, N);
    const auto p = as_polynomials<N>(f);
    require_autonomous<N>(p);
    const auto parts = detail::by_monomial(symmetric_part<multinomial>(G, detail::jacobian<N>(p)));
    const auto s = largest_eigenvalue(G, parts.at({}));
    std::vector<rational> zero(N, rational(0));
    for (const auto& [m, part] : parts) {
        if (m.empty()) continue;
        const bool even = std::all_of(m.begin(), m.end(), [](int k) { return k % 2 == 0; });
        if (even && bounds(0, G, part)) continue;
        return {verdict::consistent("gamma >= " + s.low.str(), "unknown",
                                    "the logarithmic norm of f' is not decided on all of R^m; give a box"),
                s.low, s.high, zero};
    }
    return detail::found("on R^" + std::to_string(N), s, zero);
}

/// On R x [t0, infinity) for a scalar polynomial f(t, x) whose f_x depends on t alone: decided.
template <int N, class F>
requires(N == 1) one_sided_constant one_sided_lipschitz_from(F&& f, const rational& t0) {
    const auto slope = as_polynomials<1>(f)[0].derivative(0);
    if (slope.depends_on(0))
        throw std::invalid_argument(
            "f: its derivative f_x must depend on t alone on an unbounded interval of t");
    // t = t0 + s^2 runs through [t0, infinity)
    const polynomial<rational> time{t0, 0, 1};
    const rational_function along(compose(slope.in_one_unknown(1), time));
    const auto s = supremum_on_line(along);
    if (!s) return {verdict::refuted("f_x is unbounded above: no gamma exists"), 0, 0, {}};
    std::vector<rational> at;
    if (s->point) at.push_back(t0 + *s->point * *s->point);
    const bool exactly = !s->point || !(along(*s->point) < s->low);
    return detail::found("for t >= " + t0.str() + " (the point is a time)", *s, at, exactly);
}

/// Two points with <f(x) - f(y), x - y> > gamma |x - y|^2, for a scalar rational f; nothing where gamma is a
/// one-sided Lipschitz constant on R. Exact. Throws std::invalid_argument where f divides through zero.
template <class F>
std::optional<std::pair<rational, rational>> refuting_pair(F&& f, const rational& gamma) {
    const auto r = as_rational_function(f);
    require_defined_on_line(r);
    const auto x = point_above(derivative(r), gamma);
    if (!x) return {};
    for (rational h = 1;; h = h / 2)
        if (r(*x + h) - r(*x) > gamma * h) return std::pair{*x, *x + h};
}

namespace detail {

/// One rotation of Jacobi's, T to R^T T R and C to C R, after which T(p, q) is nearly 0.
template <class Matrix>
void rotate(Matrix& T, Matrix& C, Eigen::Index p, Eigen::Index q) {
    const double theta = (T(q, q) - T(p, p)) / (2 * T(p, q));
    const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::hypot(theta, 1.0));
    const double c = 1 / std::hypot(t, 1.0), s = t * c;
    const auto turn = [c, s](double& x, double& y) {
        const double u = x;
        x = c * u - s * y;
        y = s * u + c * y;
    };
    for (Eigen::Index k = 0; k < T.rows(); ++k) turn(T(k, p), T(k, q));
    for (Eigen::Index k = 0; k < T.rows(); ++k) turn(T(p, k), T(q, k));
    for (Eigen::Index k = 0; k < T.rows(); ++k) turn(C(k, p), C(k, q));
}

/// Nearly orthonormal columns that nearly diagonalise a symmetric T: cyclic Jacobi rotations, in doubles; what is proved
/// with them does not rest on it.
template <int N>
Eigen::Matrix<double, N, N> nearly_eigenvectors(Eigen::Matrix<double, N, N> T) {
    Eigen::Matrix<double, N, N> C = Eigen::Matrix<double, N, N>::Identity();
    for (int sweep = 0; sweep < 12; ++sweep)
        for (int p = 0; p < N; ++p)
            for (int q = p + 1; q < N; ++q)
                if (std::abs(T(p, q)) > 1e-17 * (std::abs(T(p, p)) + std::abs(T(q, q)))) rotate(T, C, p, q);
    return C;
}

/// A rational number near p^-1/2, p > 0 of any size.
rational near_inverse_root(const rational& p);

/// Bounds the logarithmic norm of interval matrices J in the inner product x^T G y. First x = C y with C = V^T diag(r),
/// where V G V^T = diag(p), exactly, and r is near p^-1/2: x^T G x becomes sum_k p_k r_k^2 y_k^2, nearly |y|^2, and J
/// becomes C^-1 J C, which loses digits only as the root of G's condition number does (by the condition that scaling does
/// not mend; std::invalid_argument where none are left). Then the matrix in the middle is brought nearly to diagonal form, and
/// Gershgorin's circles do the rest in intervals.
template <int N>
class logarithmic_norm_bound {
  public:
    explicit logarithmic_norm_bound(const dense<rational>& G) {
        const auto d = tableaux::diagonalise<rational>(G);
        const auto inverse = *tableaux::inverse<rational>(d.rows);
        for (Eigen::Index k = 0; k < N; ++k) {
            const rational r = near_inverse_root(d.pivots[k]);
            lengths_(k, k) = interval(d.pivots[k] * r * r);
            for (Eigen::Index i = 0; i < N; ++i) {
                C_(i, k) = interval(d.rows(k, i) * r);
                inverse_(k, i) = interval(inverse(i, k) / r);
            }
        }
        const matrix lost = inverse_.lazyProduct(C_);
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < N; ++j)
                if (!((lost(i, j) - (i == j ? 1 : 0)).magnitude() < 1e-4))
                    throw std::invalid_argument(
                        "G: positive definite, but too nearly singular for enclosures in doubles: of its "
                        "condition number less than 1e24 must be left by a scaling of the unknowns");
    }
    interval operator()(const Eigen::Matrix<interval, N, N>& J) const {
        const matrix S = symmetric(inverse_.lazyProduct(matrix(J.lazyProduct(C_))));
        Eigen::Matrix<double, N, N> mid;
        for (int i = 0; i < N; ++i) {
            for (int j = 0; j < N; ++j) {
                if (!S(i, j).bounded()) return interval::whole();
                mid(i, j) = S(i, j).middle();
            }
        }
        const matrix R = nearly_eigenvectors<N>(mid).unaryExpr([](double x) { return interval(x); });
        const matrix D = R.transpose().lazyProduct(matrix(S.lazyProduct(R))),
                     E = R.transpose().lazyProduct(matrix(lengths_.lazyProduct(R)));
        int largest = 0;
        for (int i = 1; i < N; ++i)
            if (D(i, i).middle() > D(largest, largest).middle()) largest = i;
        double top = -std::numeric_limits<double>::infinity(), error = 0;
        for (int i = 0; i < N; ++i) {
            interval row = D(i, i), off = abs(E(i, i) - 1);
            for (int j = 0; j < N; ++j) {
                if (j == i) continue;
                row += abs(D(i, j));
                off += abs(E(i, j));
            }
            top = std::max(top, row.high());
            error = std::max(error, off.high());
        }
        // z^T D z <= top |z|^2 and (1 - error) |z|^2 <= z^T E z <= (1 + error) |z|^2
        if (!(error < 0.5)) return interval::whole();
        const double upper = (interval(top) / (top > 0 ? 1 - interval(error) : 1 + interval(error))).high();
        const interval quotient = D(largest, largest) / E(largest, largest);  // Rayleigh's
        return {std::min(quotient.low(), upper), upper};
    }

  private:
    using matrix = Eigen::Matrix<interval, N, N>;
    matrix symmetric(const matrix& J) const {
        matrix S;
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < N; ++j)
                S(i, j) = (lengths_(i, i) * J(i, j) + lengths_(j, j) * J(j, i)) * interval(0.5);
        return S;
    }
    matrix lengths_ = matrix::Zero(), C_, inverse_;
};

template <>
class logarithmic_norm_bound<1> {
  public:
    explicit logarithmic_norm_bound(const dense<rational>&) {}
    interval operator()(const Eigen::Matrix<interval, 1, 1>& J) const { return J(0, 0); }
};

template <int N>
std::vector<rational> exact_point(const box<N>& x) {
    std::vector<rational> p;
    for (int i = 0; i < N; ++i) p.push_back(exactly(x[i].low()));
    return p;
}

}  // namespace detail

/// On a convex box, f anything that evaluates in intervals and dual numbers, for all t in `time`: branch and
/// bound on the logarithmic norm of f' in the inner product x^T G y. Throws std::invalid_argument for a box
/// or G that are none, for a G so nearly singular that enclosures in doubles lose it (from a condition of some 1e24 on
/// that scaling the unknowns does not mend), and where f' cannot be bounded on the box (a division through zero).
template <int N, class F>
one_sided_constant one_sided_lipschitz_on(F&& f, const box<N>& where, const dense<rational>& G = euclidean(N),
                                          const search_limits& limits = {},
                                          const interval& time = interval::whole()) {
    require_inner_product(G, N);
    const detail::logarithmic_norm_bound<N> norm(G);
    const auto m =
        maximise<N>([&](const box<N>& x) { return norm(enclosed_jacobian<N>(f, x, time)); }, where, limits);
    if (!std::isfinite(m.low) || !std::isfinite(m.high))
        throw std::invalid_argument(
            "f: its derivative cannot be bounded on the box (division through zero, or "
            "dependence on an unbounded time)");
    const auto low = exactly(m.low), high = exactly(m.high);
    if (m.complete) return detail::found("on the box", {low, high, {}}, detail::exact_point<N>(m.point));
    return {verdict::consistent("gamma between " + shortest(m.low) + " and " + shortest(m.high),
                                "width " + shortest(limits.relative), "the limit of boxes was reached"),
            low, high, detail::exact_point<N>(m.point)};
}

/// A lower bound of gamma by random pairs in the box, in doubles: a measurement, not a proof.
template <int N, class F>
double sampled_one_sided_constant(F&& f, const box<N>& where, int pairs, unsigned seed = 1) {
    require_bounded<N>(where);
    std::mt19937_64 random(seed);
    state<double, N> x, y, fx, fy;
    double best = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < pairs; ++k) {
        for (int i = 0; i < N; ++i) {
            std::uniform_real_distribution<double> pick(where[i].low(), where[i].high());
            x[i] = pick(random);
            y[i] = pick(random);
        }
        f(0.0, x, fx);
        f(0.0, y, fy);
        best = std::max(best, (fx - fy).dot(x - y) / (x - y).squaredNorm());
    }
    return best;
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/one_sided_lipschitz-inl.hpp"
#endif
