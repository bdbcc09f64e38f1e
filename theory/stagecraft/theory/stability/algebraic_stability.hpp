// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/sturm.hpp"
#include "stagecraft/theory/stability/a_stability.hpp"
#include "stagecraft/theory/stability/irreducible.hpp"

namespace stagecraft::theory {

/// M = B A + A^T B - b b^T with B = diag(b) (Hairer-Wanner II, section IV.12; lecture, section 2.1.1).
template <class K>
tableaux::dense<K> stability_matrix(const tableau<K>& t) {
    require_shape(t);
    const auto s = t.b.size();
    tableaux::dense<K> m(s, s);
    for (Eigen::Index i = 0; i < s; ++i) {
        for (Eigen::Index j = 0; j < s; ++j) {
            m(i, j) = t.b[i] * t.A(i, j) + t.b[j] * t.A(j, i) - t.b[i] * t.b[j];
        }
    }
    return m;
}

namespace detail {

template <class K>
std::string text(const tableaux::column<K>& v) {
    std::string out;
    for (Eigen::Index i = 0; i < v.size(); ++i) out += (i == 0 ? "(" : ", ") + v[i].str();
    return out + ")";
}

/// Why M or b fails, or an empty text.
template <class K>
std::string algebraic_failure(const tableau<K>& t) {
    for (Eigen::Index i = 0; i < t.b.size(); ++i) {
        if (t.b[i] < K(0)) return "b[" + std::to_string(i + 1) + "] = " + t.b[i].str() + " < 0";
    }
    const auto m = stability_matrix(t);
    if (const auto v = tableaux::diagonalise<K>(m).negative_direction()) {
        K value(0);
        for (Eigen::Index i = 0; i < v->size(); ++i) {
            for (Eigen::Index j = 0; j < v->size(); ++j) value = value + (*v)[i] * m(i, j) * (*v)[j];
        }
        return "v^T M v = " + value.str() + " for v = " + text(*v);
    }
    return {};
}

template <class K>
std::string reduction_note(const tableau<K>& t, const tableau<K>& r) {
    if (r.stages() == t.stages()) return {};
    return " (reduced to " + std::to_string(r.stages()) + " of " + std::to_string(t.stages()) + " stages)";
}

}  // namespace detail

/// Inertia of M, exact.
template <class K>
tableaux::inertia stability_matrix_inertia(const tableau<K>& t) {
    return tableaux::diagonalise<K>(stability_matrix(t)).inertia();
}

/// b >= 0 and M positive semidefinite, by exact L D L^T; refuted with a negative weight or a vector v with
/// v^T M v < 0 (Hairer-Wanner II, section IV.12; lecture, section 2.1.1).
template <class K>
verdict algebraically_stable(const tableau<K>& t) {
    require_shape(t);
    if (auto why = detail::algebraic_failure(t); !why.empty()) return verdict::refuted(std::move(why));
    const auto n = stability_matrix_inertia(t);
    return verdict::proved("b >= 0, M has " + std::to_string(n.positive) + " positive and " +
                           std::to_string(n.zero) + " zero pivots");
}

/// B-stability. Algebraic stability implies it (Burrage-Butcher, Crouzeix); the converse holds for
/// irreducible methods (Hundsdorfer-Spijker; Hairer-Wanner II, section IV.12), so it is decided on the
/// equivalent method without idle and without doubled stages.
template <class K>
verdict b_stable(const tableau<K>& t) {
    const auto r = reduced(t);
    const auto note = detail::reduction_note(t, r);
    if (auto why = detail::algebraic_failure(r); !why.empty()) {
        return verdict::refuted("DJ- and S-irreducible" + note + " and not algebraically stable: " + why);
    }
    return verdict::proved("algebraically stable" + note);
}

/// AN-stability: |K(Z)| <= 1 for Z = diag(z_i), Re z_i <= 0, with z_i = z_j where c_i = c_j. Algebraic
/// stability implies it. On Z = i eps diag(v) it is |K|^2 = 1 - eps^2 v^T M v + O(eps^3), on Z = -eps diag(v)
/// it is K = 1 - eps b^T v + ..., so a negative direction (weight) that is constant on equal nodes refutes
/// it; for distinct nodes this is every direction and the converse is complete (Hairer-Wanner II, IV.12).
template <class K>
verdict an_stable(const tableau<K>& t) {
    const auto r = reduced(t);
    const auto note = detail::reduction_note(t, r);
    const auto why = detail::algebraic_failure(r);
    if (why.empty()) return verdict::proved("algebraically stable" + note);
    // collect the stages of equal node
    std::vector<std::vector<Eigen::Index>> groups;
    for (Eigen::Index i = 0; i < r.c.size(); ++i) {
        auto g = groups.begin();
        while (g != groups.end() && !(r.c[g->front()] == r.c[i])) ++g;
        if (g == groups.end()) g = groups.insert(g, std::vector<Eigen::Index>{});
        g->push_back(i);
    }
    const auto n = static_cast<Eigen::Index>(groups.size());
    if (n == r.b.size()) return verdict::refuted("distinct nodes" + note + ", " + why);
    const auto m = stability_matrix(r);
    tableaux::dense<K> sums(n, n);
    for (Eigen::Index a = 0; a < n; ++a) {
        K weight(0);
        for (const auto i : groups[static_cast<std::size_t>(a)]) weight = weight + r.b[i];
        if (weight < K(0)) {
            return verdict::refuted("the weights of node " +
                                    r.c[groups[static_cast<std::size_t>(a)][0]].str() + " add up to " +
                                    weight.str());
        }
        for (Eigen::Index b = 0; b < n; ++b) {
            sums(a, b) = K(0);
            for (const auto i : groups[static_cast<std::size_t>(a)]) {
                for (const auto j : groups[static_cast<std::size_t>(b)]) sums(a, b) = sums(a, b) + m(i, j);
            }
        }
    }
    if (const auto v = tableaux::diagonalise<K>(sums).negative_direction()) {
        return verdict::refuted("M summed over equal nodes is negative at v = " + detail::text(*v));
    }
    if (const auto a = a_stable(stability_function_of(r)); a.is_refuted()) {
        return verdict::refuted("not A-stable: " + a.reason());
    }
    return verdict::consistent("not computed", "none",
                               "equal nodes, A-stable, not algebraically stable: no theorem decides");
}

/// The last row of A equals b, so y_1 is the last stage (any row would do for accuracy; the theorems on stiff
/// accuracy number it last).
template <class K>
verdict stiffly_accurate(const tableau<K>& t) {
    require_shape(t);
    const auto s = t.b.size();
    for (Eigen::Index j = 0; j < s; ++j) {
        if (t.A(s - 1, j) == t.b[j]) continue;
        return verdict::refuted("A[" + std::to_string(s) + "][" + std::to_string(j + 1) + "] = " +
                                t.A(s - 1, j).str() + ", b[" + std::to_string(j + 1) + "] = " + t.b[j].str());
    }
    return verdict::proved("the last row of A is b");
}

/// A is invertible; refuted where det A = 0.
template <class K>
verdict regular_matrix(const tableau<K>& t) {
    require_shape(t);
    const K d = tableaux::determinant<K>(t.A);
    return d == K(0) ? verdict::refuted("det A = 0") : verdict::proved("det A = " + d.str());
}

/// Every eigenvalue of A has a positive real part (assumed in Hairer-Wanner II, Corollary VI.3.10; thesis,
/// Theorem 7): half-plane count of the characteristic polynomial, exact.
template <class K>
verdict eigenvalues_in_right_half_plane(const tableau<K>& t) {
    require_shape(t);
    const auto p = tableaux::characteristic_polynomial<K>(t.A);
    const auto n = tableaux::count_half_planes(p);
    if (n.left == 0 && n.axis == 0) {
        return verdict::proved("all roots of " + to_string(p) + " lie in the right half-plane");
    }
    return verdict::refuted("of the roots of " + to_string(p) + ", " + std::to_string(n.left) +
                            " lie left of and " + std::to_string(n.axis) + " on the imaginary axis");
}

}  // namespace stagecraft::theory
