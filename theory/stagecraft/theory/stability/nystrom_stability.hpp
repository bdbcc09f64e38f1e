// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <vector>

#include "stagecraft/tableau.hpp"
#include "stagecraft/theory/stability/a_stability.hpp"

namespace stagecraft::theory {

/// What a Nystrom method does to y'' = -omega^2 y in a step, H = (h omega)^2: (y, h y') is multiplied by a 2x2 matrix whose
/// entries are quotients of polynomials in H with the denominator det(I + H A_bar) (Houwen-Sommeijer 1987).
template <class K>
struct oscillation_matrix {
    polynomial<K> trace, determinant;  ///< times the denominator, times its square
    polynomial<K> denominator;

    bool keeps_area() const { return determinant == denominator * denominator; }
};

/// `position` has A_bar, b_bar and c, `weights` are b. O(s^4) operations.
template <class K>
oscillation_matrix<K> oscillation_matrix_of(const tableau<K>& position, const tableaux::column<K>& weights) {
    const auto s = position.b.size();
    const auto f = tableaux::leverrier<K>(position.A);  // adj(I + H A) = sum_l (-H)^l N_l
    const auto alternating = [](std::vector<K> v) {
        for (std::size_t l = 1; l < v.size(); l += 2) v[l] = K(0) - v[l];
        return polynomial<K>(std::move(v));
    };
    const auto form = [&](const auto& left, const auto& right) {  // H left^T adj(I + H A) right
        std::vector<K> v;
        for (const auto& n : f.adjugate) {
            K sum(0);
            for (Eigen::Index i = 0; i < s; ++i)
                for (Eigen::Index j = 0; j < s; ++j) sum = sum + left[i] * n(i, j) * right[j];
            v.push_back(sum);
        }
        return alternating(std::move(v)) * polynomial<K>::monomial(1);
    };
    const auto one = ones<K>(s);
    const auto q = alternating(f.c);
    const auto yy = q - form(position.b, one), yv = q - form(position.b, position.c);
    const auto vy = polynomial<K>() - form(weights, one), vv = q - form(weights, position.c);
    return {yy + vv, yy * vv - yv * vy, q};
}

namespace detail {

/// A polynomial with the positive roots of p, each once, and the sign of p right of 0.
template <class K>
polynomial<K> simple_roots(const polynomial<K>& p) {
    if (p.is_zero()) return p;
    int lowest = 0;
    while (p[lowest] == K(0)) ++lowest;
    const auto rest = p / polynomial<K>::monomial(lowest);
    auto q = tableaux::squarefree(rest);
    return (q[0] < K(0)) == (rest[0] < K(0)) ? q : polynomial<K>() - q;
}

}  // namespace detail

/// The largest H up to which y and y' stay bounded for every smaller one. Of methods that keep area, the interval of periodicity:
/// |trace| < 2; of others, that of absolute stability: both eigenvalues in the unit disc. Ends where it first fails, also for
/// a single H of periodicity; enclosed to 2^-bits. By Sturm chains of degree 2 s at most.
template <class K>
stability_interval<K> oscillation_interval(const oscillation_matrix<K>& m, int bits = 60) {
    const auto width = detail::two_to_minus<K>(bits);
    const auto& q = m.denominator;
    const auto square = q * q;
    std::vector<polynomial<K>> conditions{q};
    const std::size_t touching = m.keeps_area() ? 3 : 1;  // conditions of which a double root counts
    if (m.keeps_area()) {
        conditions.push_back(q + q - m.trace);
        conditions.push_back(q + q + m.trace);
    } else {
        conditions.push_back(square - m.determinant);
        conditions.push_back(square + m.determinant + m.trace * q);
        conditions.push_back(square + m.determinant - m.trace * q);
    }
    stability_interval<K> found{true, K(0), K(0)};
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        const auto& p = conditions[k];
        const auto loss = tableaux::first_sign_loss(k < touching ? detail::simple_roots(p) : p, width);
        if (loss && (found.infinite || loss->low < found.low)) found = {false, loss->low, loss->high};
    }
    return found;
}

}  // namespace stagecraft::theory
