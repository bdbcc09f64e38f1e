// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "stagecraft/theory/models/band_inertia.hpp"
#include "stagecraft/theory/models/legendre_model.hpp"

namespace stagecraft::theory {

/// The value of a condition that holds for every k: C(k) of the explicit Euler method.
inline constexpr int every = std::numeric_limits<int>::max();

/// The largest p with B(p): b^T c^{k-1} = 1/k for k <= p. It is s + r, with w orthogonal to all polynomials
/// of degree < r and no more (Hairer-Wanner II.IV.5; interpolatory weights).
template <class K>
constexpr int maximal_b(const legendre_model<K>& m) {
    return m.stages() + m.orthogonality();
}

/// The largest q with C(q): A c^{k-1} = c^k / k for k <= q. At most s for distinct nodes (C(s+1) would make w
/// a power of x - c), except that c = 0, A = 0 has every one. O(s) operations where A is tridiagonal.
template <class K>
constexpr int maximal_c(const legendre_model<K>& m) {
    const auto& a = m.A();
    const auto& j = m.integration_matrix();
    for (int k = 0; k < m.stages() && &a != &j; ++k) {
        const int end = std::max(a.end_row(k), j.end_row(k));
        for (int i = std::min(a.first_row(k), j.first_row(k)); i < end; ++i)
            if (!(a(i, k) == j(i, k))) return k;
    }
    return m.stages() == 1 && a(0, 0) == K(0) ? every : m.stages();
}

/// The largest r with D(r): sum_i b_i c_i^{k-1} a_ij = b_j (1 - c_j^k) / k for k <= r, the first r rows of
/// G A + J^T G = e_0 e_0^T with J the integration matrix: <u, A v> + <J u, v> = <1, u><1, v>. At most s for
/// distinct nodes, except that c = 1, A = 0 has every one. O(s) operations for the families.
template <class K>
constexpr int maximal_d(const legendre_model<K>& m) {
    const auto& a = m.gram_A();
    const auto& j = m.gram_integration();
    for (int i = 0; i < m.stages(); ++i) {
        const int end = std::max(a.end_column(i), j.end_row(i));
        for (int l = std::min(a.first_column(i), j.first_row(i)); l < end; ++l) {
            K sum = a(i, l);
            sum += j(l, i);
            if (!(sum == K(i == 0 && l == 0 ? 1 : 0))) return i;
        }
    }
    return m.stages() == 1 && m.A()(0, 0) == K(0) ? every : m.stages();
}

/// The largest p, q, r with B(p), C(q), D(r).
struct simplifying {
    int b = 0;
    int c = 0;
    int d = 0;

    /// min(B, C+D+1, 2C+2): the order is at least this (Butcher 1964; Hairer-Wanner II, Theorem IV.5.1).
    constexpr int order_bound() const {
        if (c == every || d == every) return b;
        return std::min({b, c + d + 1, 2 * c + 2});
    }
    /// Whether that bound is the order, since y' = x^B is not integrated exactly: the order is at most B.
    constexpr bool bound_is_order() const { return order_bound() == b; }
    /// Stage order: the largest q with B(q) and C(q).
    constexpr int stage_order() const { return std::min(b, c); }

    friend constexpr bool operator==(const simplifying&, const simplifying&) = default;
};

template <class K>
constexpr simplifying simplifying_of(const legendre_model<K>& m) {
    return {maximal_b(m), maximal_c(m), maximal_d(m)};
}

/// The algebraic stability matrix M = (b_i a_ij + b_j a_ji - b_i b_j) in Legendre coordinates, a congruence:
/// G A + A^T G - e_0 e_0^T. For Gauss, Radau and Lobatto IIIC it has at most a corner entry (Burrage 1978).
template <class K>
constexpr band_matrix<K> algebraic_stability_matrix(const legendre_model<K>& m) {
    const auto& ga = m.gram_A();
    const int width = std::max(ga.lower(), ga.upper());
    band_matrix<K> result(m.stages(), width, width);
    for (int i = 0; i < m.stages(); ++i)
        for (int j = i; j < result.end_column(i); ++j) {
            K sum = ga(i, j);
            sum += ga(j, i);
            if (j == 0) sum -= K(1);
            if (sum == K(0)) continue;
            result.entry(i, j) = sum;
            result.entry(j, i) = sum;
        }
    return result;
}

/// b >= 0 and M >= 0 (Burrage-Butcher 1979, Crouzeix 1979; Hairer-Wanner II, Definition IV.12.5); b >= 0 is
/// G >= 0.
template <class K>
constexpr bool is_algebraically_stable(const legendre_model<K>& m) {
    return is_nonnegative(inertia_of(m.gram())) && is_nonnegative(inertia_of(algebraic_stability_matrix(m)));
}

}  // namespace stagecraft::theory
