// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/enclosed_function.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/judging/order_finding.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE Eigen::MatrixXd middle(const Eigen::Matrix<ball, -1, -1>& m) {
    Eigen::MatrixXd d(m.rows(), m.cols());
    for (int i = 0; i < m.rows(); ++i)
        for (int j = 0; j < m.cols(); ++j) d(i, j) = middle(m(i, j));
    return d;
}

STAGECRAFT_INLINE ball exactly(double x) {
    int e = 0;
    const double f = std::frexp(x, &e);
    return ball(ball::mantissa(static_cast<std::int64_t>(std::ldexp(f, 53))), e - 53, 0, checker_bits);
}

STAGECRAFT_INLINE ball exactly_above(bound x) {
    int e = 0;
    std::frexp(x, &e);
    return ball(1).with_bits(checker_bits).scaled(e);
}

/// The recursion of Faddeev and Leverrier: coefficients of det(I - zA), ascending, and the matrices N_k of
/// adj(xI - A) = sum_k N_k x^{s-1-k}.
struct leverrier_balls {
    std::vector<ball> coefficients{ball(1)};
    std::vector<ball_matrix> adjugate;

    explicit leverrier_balls(const ball_matrix& A) {
        const int s = static_cast<int>(A.rows());
        ball_matrix next(s, s), product(s, s);
        for (int i = 0; i < s; ++i)
            for (int j = 0; j < s; ++j) next(i, j) = ball(i == j ? 1 : 0);
        for (int k = 1; k <= s; ++k) {
            adjugate.push_back(next);
            ball trace(0);
            for (int i = 0; i < s; ++i) {
                for (int j = 0; j < s; ++j) {
                    ball sum(0);
                    for (int l = 0; l < s; ++l) sum += A(i, l) * next(l, j);
                    product(i, j) = sum;
                }
                trace += product(i, i);
            }
            coefficients.push_back(-trace.over(k));
            next = product;
            for (int i = 0; i < s; ++i) next(i, i) += coefficients.back();
        }
    }
};

/// det(I - zA) of every A among the enclosures, by the mean value theorem: the k-th coefficient is that of the middle up
/// to what `change` says of N_{k-1}, its derivative -tr(N_{k-1} dA). The recursion alone widens several times a step.
template <class Change>
std::vector<ball> determinant_by_mean_value(const ball_matrix& A, Change change) {
    const leverrier_balls wide(A);
    ball_matrix middle = A;
    for (Eigen::Index i = 0; i < A.size(); ++i) middle.data()[i] = A.data()[i].midpoint();
    auto narrow = leverrier_balls(middle).coefficients;
    for (std::size_t k = 1; k < narrow.size(); ++k) {
        narrow[k] = narrow[k].widened(change(wide.adjugate[k - 1]));
        if (wide.coefficients[k].radius() < narrow[k].radius()) narrow[k] = wide.coefficients[k];
    }
    return narrow;
}

STAGECRAFT_INLINE std::vector<ball> determinant_of_one_minus_z(const ball_matrix& A) {
    return determinant_by_mean_value(A, [&](const ball_matrix& n) {
        bound sum = 0;
        for (Eigen::Index i = 0; i < A.rows(); ++i)
            for (Eigen::Index j = 0; j < A.rows(); ++j)
                if (A(j, i).radius() > 0)
                    sum = tableaux::upward(sum + n(i, j).upper_magnitude() * A(j, i).radius());
        return sum;
    });
}

/// The numerator det(I - z (A - 1 b^T)) in the same way; a change of b_i counts by the sum of a row of N.
STAGECRAFT_INLINE std::vector<ball> numerator_by_mean_value(const tableau<ball>& t) {
    ball_matrix m = t.A;
    for (int i = 0; i < t.stages(); ++i)
        for (int j = 0; j < t.stages(); ++j) m(i, j) -= t.b(j);
    return determinant_by_mean_value(m, [&](const ball_matrix& n) {
        bound sum = 0;
        for (int i = 0; i < t.stages(); ++i) {
            ball row(0);
            for (int j = 0; j < t.stages(); ++j) {
                row += n(i, j);
                if (t.A(j, i).radius() > 0)
                    sum = tableaux::upward(sum + n(i, j).upper_magnitude() * t.A(j, i).radius());
            }
            if (t.b(i).radius() > 0) sum = tableaux::upward(sum + row.upper_magnitude() * t.b(i).radius());
        }
        return sum;
    });
}

STAGECRAFT_INLINE Eigen::Matrix<ball, -1, -1> without_zero_lines(const Eigen::Matrix<ball, -1, -1>& A) {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        bool row = false, column = false;
        for (Eigen::Index j = 0; j < A.rows(); ++j) {
            row = row || !A(i, j).exactly_zero();
            column = column || !A(j, i).exactly_zero();
        }
        if (row && column) kept.push_back(i);
    }
    const auto n = static_cast<Eigen::Index>(kept.size());
    Eigen::Matrix<ball, -1, -1> rest(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            rest(i, j) = A(kept[static_cast<std::size_t>(i)], kept[static_cast<std::size_t>(j)]);
    return n == A.rows() ? rest : without_zero_lines(rest);
}

/// det(I - zA), coefficients beyond its degree left out.
STAGECRAFT_INLINE std::vector<ball> denominator_of(const subject<ball>& s) {
    if (!s.lower) return determinant_of_one_minus_z(without_zero_lines(s.t.A));
    std::vector<ball> q{ball(1)};
    for (int i = 0; i < s.stages(); ++i) {
        const ball& a = s.t.A(i, i);
        if (a.exactly_zero()) continue;
        q.push_back(ball(0));
        for (std::size_t k = q.size() - 1; k > 0; --k) q[k] -= a * q[k - 1];
    }
    return q;
}

/// |p(iy)|^2 as a polynomial in y^2.
STAGECRAFT_INLINE std::vector<ball> square_on_axis(const std::vector<ball>& p) {
    std::vector<ball> out(p.size(), ball(0));
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = i % 2; j < p.size(); j += 2) {
            const ball term = p[i] * p[j];  // i^{i-j} is the sign, that of (i - j)/2
            out[(i + j) / 2] += (i > j ? i - j : j - i) % 4 == 0 ? term : -term;
        }
    return out;
}

/// |p(-t e^{i alpha})|^2 as a polynomial in t: the terms t^{i+j} p_i p_j (-1)^{i+j} cos((i - j) alpha).
STAGECRAFT_INLINE std::vector<ball> square_on_ray(const std::vector<ball>& p,
                                                  const std::vector<ball>& cosine) {
    std::vector<ball> out(2 * p.size() - 1, ball(0));
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            ball term = p[i] * p[j] * cosine[i - j];
            if (i != j) term = term.times(2);
            out[i + j] += (i + j) % 2 == 0 ? term : -term;
        }
    return out;
}

STAGECRAFT_INLINE std::vector<ball> difference(std::vector<ball> x, const std::vector<ball>& y) {
    x.resize(std::max(x.size(), y.size()), ball(0));
    for (std::size_t k = 0; k < y.size(); ++k) x[k] -= y[k];
    return x;
}

}  // namespace detail

STAGECRAFT_INLINE bool enclosed_stability_function::unbounded() const {
    return std::any_of(numerator.begin() + static_cast<std::ptrdiff_t>(degree) + 1, numerator.end(),
                       [](const ball& x) { return certainly_nonzero(x); });
}

STAGECRAFT_INLINE enclosed_stability_function enclosed_stability_function::trimmed() const {
    enclosed_stability_function f = *this;
    for (std::size_t k = degree + 1; k < f.numerator.size(); ++k) f.numerator[k] = ball(0);
    f.excess = f.excess_bound = 0;
    return f;
}

/// Beyond this the numerator is found by the moments alone: the mean value theorem takes O(s^4) operations.
inline constexpr int most_stages_by_mean_value = 24;

STAGECRAFT_INLINE enclosed_stability_function stability_function_of(const subject<ball>& subject) {
    const auto& t = subject.t;
    const int s = t.stages();
    std::vector<ball> moments{ball(1)};
    Eigen::Matrix<ball, -1, 1> v(s), next(s);
    for (int i = 0; i < s; ++i) v(i) = ball(1);
    for (int j = 1; j <= s; ++j) {
        ball moment(0);
        for (int i = 0; i < s; ++i) {
            moment += t.b(i) * v(i);
            next(i) = ball(0);
            for (int k = 0; k < s; ++k) next(i) += t.A(i, k) * v(k);
        }
        moments.push_back(moment);
        v = next;
    }
    enclosed_stability_function r{{}, detail::denominator_of(subject)};
    r.degree = r.denominator.size() - 1;
    r.denominator.resize(static_cast<std::size_t>(s) + 1, ball(0));
    std::vector<ball> other;
    if (!subject.strictly_lower && s <= most_stages_by_mean_value) other = detail::numerator_by_mean_value(t);
    for (std::size_t k = 0; k < moments.size(); ++k) {
        ball sum(0);
        for (std::size_t j = 0; j <= k; ++j) sum += r.denominator[k - j] * moments[j];
        if (k < other.size() && other[k].radius() < sum.radius()) sum = other[k];
        r.numerator.push_back(sum);
        if (k <= r.degree) continue;
        r.excess = std::max(r.excess, sum.magnitude());
        r.excess_bound = std::max(r.excess_bound, sum.radius());
    }
    return r;
}

STAGECRAFT_INLINE exponential_order exponential_order_of(const enclosed_stability_function& f) {
    exponential_order found;
    for (int k = 1; k < 2 * static_cast<int>(f.numerator.size()); ++k) {
        ball defect(0), term = ball(1).with_bits(checker_bits);  // 1/(k-j)!
        bound scale = 0;
        for (int j = k; j >= 0; --j) {
            if (static_cast<std::size_t>(j) < f.denominator.size()) {
                const ball part = f.denominator[static_cast<std::size_t>(j)] * term;
                defect += part;
                scale = std::max(scale, part.magnitude());
            }
            term = term.over(k - j + 1);
        }
        if (static_cast<std::size_t>(k) < f.numerator.size())
            defect -= f.numerator[static_cast<std::size_t>(k)];
        if (certainly_nonzero(defect) || defect.radius() > equality_level * scale) break;
        found = {k, std::max(found.residual, defect.magnitude()),
                 std::max(found.bound_on_it, defect.radius())};
    }
    return found;
}

STAGECRAFT_INLINE std::vector<ball> margin_on_axis(const enclosed_stability_function& f, int leave_out) {
    auto e = detail::difference(detail::square_on_axis(f.denominator), detail::square_on_axis(f.numerator));
    for (std::size_t k = 0; k < std::min(e.size(), static_cast<std::size_t>(leave_out)); ++k) e[k] = ball(0);
    return e;
}

STAGECRAFT_INLINE std::vector<ball> denominator_on_axis(const enclosed_stability_function& f) {
    return detail::square_on_axis(f.denominator);
}

STAGECRAFT_INLINE std::vector<ball> margin_on_ray(const enclosed_stability_function& f, const ball& u) {
    std::vector<ball> cosine{ball(1), u};
    while (cosine.size() < f.numerator.size() + 1)
        cosine.push_back((u * cosine.back()).times(2) - cosine[cosine.size() - 2]);
    return detail::difference(detail::square_on_ray(f.denominator, cosine),
                              detail::square_on_ray(f.numerator, cosine));
}

STAGECRAFT_INLINE unitary_function unitary_of(const enclosed_stability_function& f) {
    if (f.degree == 0 || !certainly_nonzero(f.denominator[f.degree])) return {};
    unitary_function u{f.degree % 2 == 0 ? 1 : -1};
    for (std::size_t k = 0; k < f.numerator.size(); ++k) {
        const ball defect =
            k % 2 == 0 ? f.numerator[k] - f.denominator[k] : f.numerator[k] + f.denominator[k];
        const bound scale = std::max(f.denominator[k].magnitude(), f.denominator[f.degree].magnitude());
        if (certainly_nonzero(defect) || defect.radius() > rounding_level * scale) return {};
        u.residual = std::max(u.residual, defect.magnitude());
        u.bound_on_it = std::max(u.bound_on_it, defect.radius());
    }
    return u;
}

namespace detail {

/// Every solution of A x = 1, by an approximate inverse C: |x - x_0| <= |C (1 - A x_0)| / (1 - |I - C A|) in the
/// maximum norm (Neumann's series). Nothing where |I - C A| is not certainly below 1/2.
STAGECRAFT_INLINE std::optional<std::vector<ball>> solution_of_ones(const Eigen::Matrix<ball, -1, -1>& A) {
    const auto n = static_cast<std::size_t>(A.rows());
    const auto at = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    const Eigen::MatrixXd inverse = middle(A).inverse();
    if (!inverse.allFinite()) return std::nullopt;
    Eigen::Matrix<ball, -1, -1> c(A.rows(), A.rows());
    for (Eigen::Index i = 0; i < c.size(); ++i) c.data()[i] = exactly(inverse.data()[i]);
    bound contraction = 0;
    for (std::size_t i = 0; i < n; ++i) {
        bound row = 0;
        for (std::size_t j = 0; j < n; ++j) {
            ball entry(i == j ? 1 : 0);
            for (std::size_t k = 0; k < n; ++k) entry -= c(at(i), at(k)) * A(at(k), at(j));
            row = tableaux::upward(row + entry.upper_magnitude());
        }
        contraction = std::max(contraction, row);
    }
    if (!(contraction <= 0.5L)) return std::nullopt;
    std::vector<ball> x(n, ball(0).with_bits(checker_bits)), step(n), defect(n);
    bound left = 0;
    for (int sweep = 0;; ++sweep) {
        bound now = 0;
        for (std::size_t i = 0; i < n; ++i) {
            defect[i] = ball(1);
            for (std::size_t j = 0; j < n; ++j) defect[i] -= A(at(i), at(j)) * x[j];
        }
        for (std::size_t i = 0; i < n; ++i) {
            step[i] = ball(0);
            for (std::size_t j = 0; j < n; ++j) step[i] += c(at(i), at(j)) * defect[j];
            now = std::max(now, step[i].upper_magnitude());
        }
        if (sweep == 60 || (sweep > 0 && !(now < 0.9L * left))) {
            for (ball& xi : x) xi = xi.widened(tableaux::upward(now / (1 - contraction)));
            return x;
        }
        left = now;
        for (std::size_t i = 0; i < n; ++i) x[i] = (x[i] + step[i].midpoint()).midpoint();
    }
}

}  // namespace detail

STAGECRAFT_INLINE std::optional<ball> value_at_infinity(const subject<ball>& s,
                                                        const enclosed_stability_function& f) {
    std::optional<ball> quotient;
    const ball& bottom = f.denominator[f.degree];
    if (!f.unbounded() && certainly_nonzero(bottom)) quotient = f.numerator[f.degree] / bottom;
    if (static_cast<int>(f.degree) < s.stages())  // singular by its zeros
        return f.excess > 0 || f.excess_bound > 0 ? std::nullopt : quotient;
    const auto x = detail::solution_of_ones(s.t.A);
    if (!x) return quotient;
    ball value(1);
    for (int i = 0; i < s.stages(); ++i) value -= s.t.b(i) * (*x)[static_cast<std::size_t>(i)];
    if (quotient && quotient->radius() < value.radius()) return quotient;
    return value;
}

}  // namespace stagecraft::theory
