// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/rounded_properties.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/judging/order_finding.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

/// The parts of a conjunction of equalities, the first certain failure deciding.
class equalities {
  public:
    /// `scale`: the size of the quantities whose difference `defect` is.
    void add(const ball& defect, bound scale, const std::string& name) {
        scale_ = std::max(scale_, scale);
        if (failure_.empty() && certainly_nonzero(defect)) failure_ = name + " leaves " + shown(defect);
        residual_ = std::max(residual_, defect.magnitude());
        radius_ = std::max(radius_, defect.radius());
    }
    theory::verdict verdict() const {
        if (!failure_.empty()) return theory::verdict::refuted(failure_);
        return open_case(residual_, radius_, scale_, data_reason);
    }

  private:
    std::string failure_;
    bound residual_ = 0;
    bound radius_ = 0;
    bound scale_ = 0;
};

STAGECRAFT_INLINE ball stability_matrix_entry(const tableau<ball>& t, int i, int j) {
    return t.b(i) * t.A(i, j) + t.b(j) * t.A(j, i) - t.b(i) * t.b(j);
}

/// Whether the stages certainly all matter and differ, as the converse theorems need.
STAGECRAFT_INLINE bool certainly_irreducible(const tableau<ball>& t) {
    for (int i = 0; i < t.stages(); ++i) {
        if (!certainly_nonzero(t.b(i))) return false;
        for (int j = 0; j < i; ++j)
            if (!certainly_nonzero(t.c(i) - t.c(j))) return false;
    }
    return true;
}

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

STAGECRAFT_INLINE std::vector<ball> determinant_of_one_minus_z(const Eigen::Matrix<ball, -1, -1>& A) {
    const int s = static_cast<int>(A.rows());
    std::vector<ball> coefficients{ball(1)};
    Eigen::Matrix<ball, -1, -1> next(s, s), product(s, s);
    for (int i = 0; i < s; ++i)
        for (int j = 0; j < s; ++j) next(i, j) = ball(i == j ? 1 : 0);
    for (int k = 1; k <= s; ++k) {
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
    return coefficients;
}

STAGECRAFT_INLINE enclosed_stability_function stability_function_of(const tableau<ball>& t) {
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
    enclosed_stability_function r{{}, determinant_of_one_minus_z(t.A)};
    for (std::size_t k = 0; k < moments.size(); ++k) {
        ball sum(0);
        for (std::size_t j = 0; j <= k; ++j) sum += r.denominator[k - j] * moments[j];
        r.numerator.push_back(sum);
    }
    return r;
}

STAGECRAFT_INLINE std::size_t most_implicit_stages(const tableau<ball>& t) {
    std::vector<int> left(static_cast<std::size_t>(t.stages()));
    std::iota(left.begin(), left.end(), 0);
    const auto none = [&](auto&& entry) {
        return std::all_of(left.begin(), left.end(),
                           [&](int j) { return !certainly_nonzero(entry(j)) && entry(j).radius() == 0; });
    };
    const auto is_explicit = [&](int i) {
        return none([&](int j) { return t.A(i, j); }) || none([&](int j) { return t.A(j, i); });
    };
    for (;;) {
        const auto found = std::find_if(left.begin(), left.end(), is_explicit);
        if (found == left.end()) return left.size();
        left.erase(found);
    }
}

/// |p(iy)|^2.
STAGECRAFT_INLINE ball squared_on_axis(const std::vector<ball>& p, const ball& y) {
    ball real(0), imaginary(0), power(1);
    for (std::size_t k = 0; k < p.size(); ++k) {
        const ball term = k % 4 < 2 ? p[k] * power : -(p[k] * power);
        (k % 2 == 0 ? real : imaginary) += term;
        power *= y;
    }
    return real * real + imaginary * imaginary;
}

STAGECRAFT_INLINE ball at(const std::vector<ball>& p, const ball& x) {
    ball sum(0);
    for (auto c = p.rbegin(); c != p.rend(); ++c) sum = sum * x + *c;
    return sum;
}

/// Symmetric and symplectic methods have R(z) R(-z) = 1, so |R(iy)| = 1 (Hairer-Lubich-Wanner, sections V.1
/// and VI.4): refuted where R is a polynomial and not constant, and by y = 1 or 4.
STAGECRAFT_INLINE std::optional<verdict> not_unitary(const subject<ball>& s) {
    if (s.strictly_lower && certainly_nonzero(s.t.b.sum()))
        return verdict::refuted("explicit: R is a polynomial and not constant, so R(z) R(-z) is not 1");
    const auto r = stability_function_of(s.t);
    for (const int y : {1, 4}) {
        const ball gap = squared_on_axis(r.numerator, ball(y)) - squared_on_axis(r.denominator, ball(y));
        if (certainly_nonzero(gap)) return verdict::refuted("|R(iy)| is not 1 at y = " + std::to_string(y));
    }
    return std::nullopt;
}

/// A unit eigenvector of the lowest eigenvalue of a symmetric matrix, by cyclic Jacobi rotations.
/// Eigen's solver for symmetric matrices would take two seconds to compile wherever this is included.
STAGECRAFT_INLINE Eigen::VectorXd lowest_eigenvector(Eigen::MatrixXd m) {
    const Eigen::Index n = m.rows();
    Eigen::MatrixXd vectors = Eigen::MatrixXd::Identity(n, n);
    for (int sweep = 0; sweep < 50; ++sweep) {
        double off = 0;
        for (Eigen::Index p = 0; p < n; ++p)
            for (Eigen::Index q = p + 1; q < n; ++q) {
                off += m(p, q) * m(p, q);
                Eigen::JacobiRotation<double> rotation;
                if (!rotation.makeJacobi(m, p, q)) continue;
                m.applyOnTheLeft(p, q, rotation.adjoint());
                m.applyOnTheRight(p, q, rotation);
                vectors.applyOnTheRight(p, q, rotation);
            }
        if (off <= 1e-30 * m.squaredNorm()) break;
    }
    Eigen::Index lowest = 0;
    m.diagonal().minCoeff(&lowest);
    return vectors.col(lowest);
}

}  // namespace detail

STAGECRAFT_INLINE verdict rounded_stiffly_accurate(const subject<ball>& s) {
    detail::equalities all;
    const int last = s.stages() - 1;
    for (int j = 0; j <= last; ++j)
        all.add(s.t.A(last, j) - s.t.b(j), s.t.b(j).magnitude(),
                place{part::A, last, j}.name() + " = " + place{part::b, j, 0}.name());
    return all.verdict();
}

STAGECRAFT_INLINE verdict rounded_symplectic(const subject<ball>& s) {
    if (const auto damped = detail::not_unitary(s)) return *damped;
    detail::equalities all;
    for (int i = 0; i < s.stages(); ++i)
        for (int j = 0; j <= i; ++j)
            all.add(detail::stability_matrix_entry(s.t, i, j), (s.t.b(i) * s.t.b(i)).magnitude(),
                    "M[" + std::to_string(i + 1) + "][" + std::to_string(j + 1) + "] = 0");
    const auto v = all.verdict();
    if (v.is_refuted() && !detail::certainly_irreducible(s.t))
        return verdict::inconclusive("nonzero", "none", "M is not 0, but the method may be reducible");
    return v;
}

STAGECRAFT_INLINE verdict rounded_symmetric(const subject<ball>& s) {
    if (const auto damped = detail::not_unitary(s)) return *damped;
    const auto& t = s.t;
    std::vector<int> sigma;
    bool unique = detail::certainly_irreducible(t);
    for (int i = 0; i < s.stages(); ++i) {
        int mirror = -1;
        for (int k = 0; k < s.stages(); ++k) {
            if (certainly_nonzero(t.c(i) + t.c(k) - ball(1))) continue;
            unique = unique && mirror < 0;
            mirror = k;
        }
        if (mirror < 0 && unique) return verdict::refuted("no node mirrors " + place{part::c, i, 0}.name());
        sigma.push_back(mirror);
    }
    if (!unique)
        return verdict::inconclusive("not computed", "none",
                                     "the nodes do not determine the stages' mirror images");
    detail::equalities all;
    for (int i = 0; i < s.stages(); ++i)
        for (int j = 0; j < s.stages(); ++j)
            all.add(t.A(i, j) + t.A(sigma[i], sigma[j]) - t.b(j), t.b(j).magnitude(),
                    place{part::A, i, j}.name() + " + " + place{part::A, sigma[i], sigma[j]}.name() + " = " +
                        place{part::b, j, 0}.name());
    return all.verdict();
}

STAGECRAFT_INLINE verdict rounded_algebraically_stable(const subject<ball>& s) {
    const int n = s.stages();
    Eigen::Matrix<ball, -1, -1> m(n, n);
    for (int i = 0; i < n; ++i) {
        if (certainly_negative(s.t.b(i))) return verdict::refuted(place{part::b, i, 0}.name() + " < 0");
        for (int j = 0; j < n; ++j) m(i, j) = detail::stability_matrix_entry(s.t, i, j);
    }
    const Eigen::MatrixXd middle = detail::middle(m);
    if (!middle.allFinite()) return verdict::inconclusive("not computed", "none", data_reason);
    const Eigen::VectorXd v = detail::lowest_eigenvector(middle);
    ball form(0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) form += detail::exactly(v(i)) * m(i, j) * detail::exactly(v(j));
    if (certainly_negative(form)) {
        std::string text;
        for (int i = 0; i < n; ++i) text += (i ? ", " : "") + brief(v(i));
        return verdict::refuted("v^T M v = " + shown(form) + " for v = (" + text + ")");
    }
    bound scale = 0;
    for (int i = 0; i < n; ++i) scale = std::max(scale, (s.t.b(i) * s.t.b(i)).magnitude());
    // A positive v^T M v is what is claimed: only what is missing from 0 is a residual.
    return open_case(form.middle() < 0 ? form.magnitude() : 0, form.radius(), scale, data_reason);
}

STAGECRAFT_INLINE verdict rounded_a_stable(const subject<ball>& s) {
    ball sum(0);
    for (int i = 0; i < s.stages(); ++i) sum += s.t.b(i);
    if (s.strictly_lower && certainly_nonzero(sum))
        return verdict::refuted("explicit: R is a polynomial and not constant");
    const auto r = detail::stability_function_of(s.t);
    bound gap = 0, radius = 0;
    for (int k = -200; k <= 200; ++k) {
        const double y = std::exp2(k / 15.0);
        const ball q = detail::squared_on_axis(r.denominator, detail::exactly(y));
        const ball p = detail::squared_on_axis(r.numerator, detail::exactly(y));
        if (certainly_negative(q - p)) return verdict::refuted("|R(iy)| > 1 at y = " + brief(y));
        if (certainly_nonzero(q)) {
            const ball gain = p / q - ball(1);
            if (certainly_positive(gain)) return verdict::refuted("|R(iy)| > 1 at y = " + brief(y));
            if (gain.middle() > 0) gap = std::max(gap, gain.magnitude());
            radius = std::max(radius, gain.radius());
        } else {
            radius = std::numeric_limits<bound>::infinity();
        }
        const ball left = detail::at(r.numerator, detail::exactly(-y));
        const ball right = detail::at(r.denominator, detail::exactly(-y));
        if (certainly_negative(right * right - left * left))
            return verdict::refuted("|R(x)| > 1 at x = " + brief(-y));
    }
    return open_case(gap, radius, 1, data_reason);
}

STAGECRAFT_INLINE verdict rounded_l_stable(const subject<ball>& s) {
    const auto a = rounded_a_stable(s);
    if (a.is_refuted()) return a;
    const auto r = detail::stability_function_of(s.t);
    const std::size_t degree = detail::most_implicit_stages(s.t);
    verdict all = a;
    for (std::size_t k = degree; k < r.numerator.size(); ++k) {
        const ball& p = r.numerator[k];
        if (certainly_nonzero(p))
            return verdict::refuted("R(inf) is not 0: Q has degree " + std::to_string(degree) +
                                    ", and P the coefficient " + shown(p) + " of z^" + std::to_string(k));
        all = both(all, open_case(p.magnitude(), p.radius(), r.denominator[degree].magnitude(), data_reason));
    }
    return all;
}

}  // namespace stagecraft::theory
