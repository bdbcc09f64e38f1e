// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/lyapunov_function.hpp"

#include <numeric>
#include <random>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/dynamics/inner_product.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE multinomial lowest_part(const multinomial& p) {
    const auto degree = [](const multinomial::monomial& m) { return std::accumulate(m.begin(), m.end(), 0); };
    int least = p.degree();
    for (const auto& [m, a] : p.terms()) least = std::min(least, degree(m));
    multinomial part;
    for (const auto& [m, a] : p.terms()) {
        if (degree(m) != least) continue;
        multinomial term(a);
        for (std::size_t i = 0; i < m.size(); ++i)
            for (int k = 0; k < m[i]; ++k) term *= multinomial::unknown(static_cast<int>(i));
        part += term;
    }
    return part;
}

/// Exact: the direction in which a quadratic form is least, relative to a congruent diagonal form, where that violates
/// what is asked.
STAGECRAFT_INLINE std::optional<std::vector<rational>> violated_by_form(const multinomial& q, int unknowns,
                                                                        sign_asked asked) {
    dense<rational> Q(unknowns, unknowns);
    for (int i = 0; i < unknowns; ++i)
        for (int j = 0; j < unknowns; ++j) Q(i, j) = q.derivative(i).derivative(j).constant();
    const auto d = tableaux::diagonalise<rational>(Q);
    for (Eigen::Index k = 0; k < unknowns; ++k) {
        if (d.pivots[k] > 0 || (d.pivots[k] == 0 && asked == sign_asked::not_negative)) continue;
        std::vector<rational> x;
        for (Eigen::Index i = 0; i < unknowns; ++i) x.push_back(d.rows(k, i));
        return x;
    }
    return {};
}

STAGECRAFT_INLINE std::optional<std::vector<rational>> violating_point(const multinomial& p, int unknowns,
                                                                       sign_asked asked) {
    const auto violates = [&](const std::vector<rational>& x) {
        const rational value = p(x);
        return value < 0 || (value == 0 && asked == sign_asked::positive_off_0);
    };
    if (const auto part = lowest_part(p); part.degree() == 2 || part.is_zero()) {
        auto x = violated_by_form(part, unknowns, asked);
        if (p == part) return x;
        for (int halvings = 0; x && halvings < 60; ++halvings) {
            if (violates(*x)) return x;
            for (auto& a : *x) a /= 2;
        }
    }
    std::mt19937 random(1);
    std::uniform_int_distribution<int> pick(-20, 20);
    for (const int scale : {10, 1, 100, 1000}) {
        for (int k = 0; k < 500; ++k) {
            std::vector<rational> x;
            for (int i = 0; i < unknowns; ++i)
                x.emplace_back(tableaux::integer(k == 0 ? (i == 0 ? 1 : 0) : pick(random)),
                               tableaux::integer(scale));
            const bool origin = std::all_of(x.begin(), x.end(), [](const rational& a) { return a == 0; });
            if (!origin && violates(x)) return x;
        }
    }
    return {};
}

/// The least power of x_i alone in p; 0 where there is none.
STAGECRAFT_INLINE int lowest_power(const multinomial& p, int i) {
    int least = 0;
    for (const auto& [m, a] : p.terms()) {
        const int k = multinomial::exponent(m, i);
        const bool alone = static_cast<int>(m.size()) == i + 1 && std::accumulate(m.begin(), m.end(), 0) == k;
        if (alone && (least == 0 || k < least)) least = k;
    }
    return least;
}

STAGECRAFT_INLINE int axis_without_even_power(const multinomial& p, int unknowns) {
    for (int i = 0; i < unknowns; ++i)
        if (const int k = lowest_power(p, i); k == 0 || k % 2 != 0) return i;
    return -1;
}

STAGECRAFT_INLINE bool exceeds_powers(const multinomial& p, int unknowns) {
    multinomial powers;
    for (int i = 0; i < unknowns; ++i) {
        multinomial term(1);
        for (int k = 0; k < lowest_power(p, i); ++k) term *= multinomial::unknown(i);
        powers += term;
    }
    for (const int bits : {20, 60, 200})
        if (is_sum_of_squares(p - multinomial(tableaux::scaled(rational(1), -bits)) * powers, unknowns))
            return true;
    return false;
}

STAGECRAFT_INLINE std::string text_of(const std::vector<rational>& x) {
    std::string out;
    for (const auto& a : x) out += (out.empty() ? "(" : ", ") + a.str();
    return out + ")";
}

}  // namespace detail

}  // namespace stagecraft::theory
