// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/rounded_properties.hpp"

#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/judging/enclosed_function.hpp"
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

/// Symmetric and symplectic methods have R(z) R(-z) = 1, so |R(iy)| = 1 (Hairer-Lubich-Wanner, sections V.1
/// and VI.4): refuted where R is a polynomial and not constant, and by y = 1 or 4.
STAGECRAFT_INLINE std::optional<verdict> not_unitary(const subject<ball>& s) {
    if (s.strictly_lower && certainly_nonzero(s.t.b.sum()))
        return verdict::refuted("explicit: R is a polynomial and not constant, so R(z) R(-z) is not 1");
    const auto margin = margin_on_axis(stability_function_of(s));
    for (const int y : {1, 4}) {
        ball gap(0);
        for (auto c = margin.rbegin(); c != margin.rend(); ++c) gap = gap.times(y * y) + *c;
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

/// Whether m + epsilon I is positive definite for every symmetric m in the enclosures: pivots of its LDL^T.
STAGECRAFT_INLINE bool certainly_definite(Eigen::Matrix<ball, -1, -1> m, const ball& epsilon) {
    const auto n = static_cast<int>(m.rows());
    for (int k = 0; k < n; ++k) {
        m(k, k) += epsilon;
        if (!certainly_positive(m(k, k))) return false;
        for (int i = k + 1; i < n; ++i)
            for (int j = k + 1; j < n; ++j) m(i, j) -= m(i, k) * m(k, j) / m(k, k);
    }
    return true;
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
    const bound residual = form.middle() < 0 ? form.magnitude() : 0;
    bound widest = 0;
    for (Eigen::Index i = 0; i < m.size(); ++i) widest = std::max(widest, m.data()[i].radius());
    for (bound e = std::max(widest + residual, scale * 0x1p-330L); e < scale / 10; e *= 4)
        if (detail::certainly_definite(m, detail::exactly_above(e)))
            return open_case(residual, e, scale, data_reason);
    return verdict::undecided("whether M >= 0: the digits leave its eigenvalues open");
}

}  // namespace stagecraft::theory
