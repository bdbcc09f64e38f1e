// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "stagecraft/theory/stability/a_stability.hpp"
#include "stagecraft/theory/stability/irreducible.hpp"

namespace stagecraft::theory {

namespace detail {

/// True if p is negative right after 0.
template <class K>
bool falls_below_zero_at_once(const polynomial<K>& p) {
    for (int l = 0; l <= p.degree(); ++l)
        if (!(p[l] == K(0))) return p[l] < K(0);
    return false;
}

}  // namespace detail

/// K = [A 0; b^T 0].
template <class K>
tableaux::dense<K> bordered(const tableau<K>& t) {
    const auto n = t.b.size() + 1;
    tableaux::dense<K> k(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            k(i, j) = j == n - 1 ? K(0) : i == n - 1 ? t.b[j] : t.A(i, j);
        }
    }
    return k;
}

/// The largest r with (I + rS)^-1 K >= 0 and (I + rS)^-1 1 >= 0 on [0, r] for each of the bordered matrices K of one size, S their
/// sum (Higueras 2006; for one of them Kraaijevanger 1991). Every entry is a quotient of polynomials in r over the field, so the
/// first sign change is decided exactly and enclosed to 2^-bits. Cost: O(s^4) operations and O(s^2) Sturm chains of
/// degree <= s for each matrix.
template <class K>
stability_interval<K> common_ssp_radius(const std::vector<tableaux::dense<K>>& all, int bits = 60) {
    tableaux::dense<K> sum_of_all = all.front();
    for (std::size_t m = 1; m < all.size(); ++m) sum_of_all = sum_of_all + all[m];
    const auto n = sum_of_all.rows();
    // With x = -1/r: adj(I + rS) = sum_l (-1)^l N_l r^l and det(I + rS) = sum_l (-1)^l c_l r^l from
    // adj(xI - S) = sum_l N_l x^(n-1-l), det(xI - S) = sum_l c_l x^(n-l).
    const auto f = tableaux::leverrier<K>(sum_of_all);
    const auto polynomial_of = [&](auto coefficient) {
        std::vector<K> v;
        for (std::size_t l = 0; l < f.adjugate.size(); ++l) {
            const K a = coefficient(f.adjugate[l]);
            v.push_back(l % 2 == 0 ? a : K(0) - a);
        }
        return polynomial<K>(std::move(v));
    };
    std::vector<polynomial<K>> conditions;
    {
        std::vector<K> v;
        for (std::size_t l = 0; l < f.c.size(); ++l) v.push_back(l % 2 == 0 ? f.c[l] : K(0) - f.c[l]);
        conditions.emplace_back(std::move(v));  // the determinant: positive up to its first root
    }
    for (Eigen::Index i = 0; i < n; ++i) {
        conditions.push_back(polynomial_of([&](const tableaux::dense<K>& a) {
            K sum(0);
            for (Eigen::Index j = 0; j < n; ++j) sum = sum + a(i, j);
            return sum;
        }));
        for (const auto& k : all) {
            for (Eigen::Index j = 0; j + 1 < n; ++j) {
                conditions.push_back(polynomial_of([&](const tableaux::dense<K>& a) {
                    K sum(0);
                    for (Eigen::Index l = 0; l < n; ++l) {
                        if (!(k(l, j) == K(0))) sum = sum + a(i, l) * k(l, j);
                    }
                    return sum;
                }));
            }
        }
    }
    for (const auto& p : conditions)  // the cheap look first
        if (detail::falls_below_zero_at_once(p)) return {false, K(0), K(0)};
    stability_interval<K> radius{true, K(0), K(0)};
    const K width = detail::two_to_minus<K>(bits);
    for (std::size_t index = 0; index < conditions.size(); ++index) {
        const auto& p = conditions[index];
        // the determinant must not even touch zero
        const auto loss = tableaux::first_sign_loss(index == 0 ? tableaux::squarefree(p) : p, width);
        if (!loss || (!radius.infinite && radius.low <= loss->low)) continue;
        radius = {false, loss->low, loss->high};
    }
    return radius;
}

/// The radius of absolute monotonicity, which is the SSP coefficient of an irreducible method (Kraaijevanger 1991;
/// Gottlieb-Ketcheson-Shu, section 4). Taken of the equivalent irreducible method.
template <class K>
stability_interval<K> ssp_radius(const tableau<K>& t, int bits = 60) {
    return common_ssp_radius<K>({bordered(reduced(t))}, bits);
}

}  // namespace stagecraft::theory
