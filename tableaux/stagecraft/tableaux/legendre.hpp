// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/polynomial.hpp"

namespace stagecraft::tableaux {

// The shifted Legendre polynomials P_k on [0, 1]: P_k(1) = 1, integral of P_j P_k = delta_jk / (2k+1),
//     x P_k = ((k+1) P_{k+1} + (2k+1) P_k + k P_{k-1}) / (2 (2k+1)),
//     integral of P_k from 0 to x = (P_{k+1} - P_{k-1}) / (2 (2k+1)), k > 0;  (P_1 + P_0) / 2 for k = 0.

/// P_k in powers of x: the sum over j of (-1)^(k-j) binom(k, j) binom(k+j, j) x^j. O(k) operations.
template <class K>
constexpr polynomial<K> shifted_legendre(int k) {
    std::vector<K> a;
    K term(k % 2 == 0 ? 1 : -1);
    for (int j = 0; j <= k; ++j) {
        a.push_back(term);
        term = term * K((j - k) * (k + j + 1)) / K((j + 1) * (j + 1));
    }
    return polynomial<K>(std::move(a));
}

/// Coordinates in P_0, P_1, ... to powers of x. O(n^2) operations, less where coordinates vanish.
template <class K>
constexpr polynomial<K> from_legendre(const std::vector<K>& coordinates) {
    polynomial<K> p;
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
        if (coordinates[k] == K(0)) continue;
        p += polynomial<K>(coordinates[k]) * shifted_legendre<K>(static_cast<int>(k));
    }
    return p;
}

/// Coordinates of x u, one longer than u.
template <class K>
constexpr std::vector<K> legendre_times_x(const std::vector<K>& u) {
    std::vector<K> v(u.size() + 1, K(0));
    for (std::size_t k = 0; k < u.size(); ++k) {
        if (u[k] == K(0)) continue;
        const int n = static_cast<int>(k);
        const K f = u[k] / K(2 * (2 * n + 1));
        v[k + 1] = v[k + 1] + f * K(n + 1);
        v[k] = v[k] + u[k] / K(2);
        if (k > 0) v[k - 1] = v[k - 1] + f * K(n);
    }
    return v;
}

/// Powers of x to coordinates in P_0, ..., P_degree, by Horner's rule in that basis. O(n^2) operations.
template <class K>
constexpr std::vector<K> to_legendre(const polynomial<K>& p) {
    std::vector<K> u;
    for (int k = p.degree(); k >= 0; --k) {
        u = u.empty() ? std::vector<K>(1, K(0)) : legendre_times_x(u);
        u[0] = u[0] + p[k];
    }
    return u;
}

}  // namespace stagecraft::tableaux
