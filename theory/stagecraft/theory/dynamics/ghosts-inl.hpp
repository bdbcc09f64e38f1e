// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/ghosts.hpp"

#include <string>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE int periodic_points::ghosts() const {
    int n = 0;
    for (const auto& p : points) n += p.equilibrium ? 0 : 1;
    return n;
}

namespace detail {

STAGECRAFT_INLINE rational_function squared(const rational_function& m) {
    const auto substituted = [&](const polynomial<rational>& p, int degree) {
        polynomial<rational> sum, top(rational(1));
        for (int k = 0; k <= p.degree(); ++k) {
            sum += polynomial<rational>(p[k]) * top * power(m.denominator(), degree - k);
            top *= m.numerator();
        }
        return sum;
    };
    const int degree = std::max(m.numerator().degree(), m.denominator().degree());
    auto divisors = m.divisors();
    for (const auto& d : m.divisors()) divisors.push_back(substituted(d, d.degree()));
    return {substituted(m.numerator(), degree), substituted(m.denominator(), degree), divisors};
}

STAGECRAFT_INLINE split_zeros::split_zeros(polynomial<rational> p, const rational_function& map)
    : defined(squarefree(std::move(p))) {
    for (const auto& d : map.divisors()) {
        const auto common = gcd(defined, d);
        excluded *= common;
        defined = defined / common;
    }
}

STAGECRAFT_INLINE theory::verdict split_zeros::verdict() const {
    std::string where;
    for (const auto& root : tableaux::isolate_real_roots(excluded)) {
        const auto r = refine(excluded, root, rational(1, 1LL << 50));
        where += (where.empty() ? "" : ", ") + (r.exact() ? r.low.str() : shortest(r.low.to<double>()));
    }
    const std::string all = "all real zeros of a polynomial of degree " + std::to_string(defined.degree());
    return verdict::proved(where.empty() ? all
                                         : all + "; excluded: " + where + ", where a stage divides by zero");
}

STAGECRAFT_INLINE verdict too_high(int degree) {
    return verdict::consistent("degree " + std::to_string(degree), std::to_string(largest_ghost_degree),
                               "the limit of the degree; nothing was counted");
}

}  // namespace detail

}  // namespace stagecraft::theory
