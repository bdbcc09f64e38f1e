// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/stability/nodal_stability.hpp"

#include <cstddef>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/stability/schwarz.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE scaled_polynomial determinant_of_one_minus_z(const band_matrix<rational>& h, int n,
                                                               const rational& first) {
    std::vector<scaled_polynomial> minors{{{1}, 1}};
    struct term {
        const scaled_polynomial* minor;
        rational factor;
        std::size_t shift;
    };
    for (int k = 0; k < n; ++k) {
        std::vector<term> terms{{&minors.back(), 1, 0}};
        rational product(1);
        for (int i = k; i >= h.first_row(k); --i) {
            if (i < k) product *= h(i + 1, i);
            const rational entry = i == 0 && k == 0 ? first : h(i, k);
            if (entry == 0) continue;
            terms.push_back({&minors[static_cast<std::size_t>(i)], -entry * product,
                             static_cast<std::size_t>(k - i + 1)});
        }
        scaled_polynomial next;
        for (const term& t : terms)
            next.denominator =
                tableaux::lcm(next.denominator, integer(t.minor->denominator * t.factor.denominator()));
        next.numerators.resize(static_cast<std::size_t>(k) + 2);
        for (const term& t : terms) {
            const integer scale =
                t.factor.numerator() * (next.denominator / (t.minor->denominator * t.factor.denominator()));
            for (std::size_t j = 0; j < t.minor->numerators.size(); ++j)
                next.numerators[j + t.shift] += scale * t.minor->numerators[j];
        }
        minors.push_back(std::move(next));
    }
    return std::move(minors.back());
}

STAGECRAFT_INLINE tableaux::polynomial<rational> unscaled(const scaled_polynomial& p) {
    std::vector<rational> a;
    for (const integer& n : p.numerators) a.emplace_back(n, p.denominator);
    return tableaux::polynomial<rational>(std::move(a));
}

}  // namespace detail

STAGECRAFT_INLINE stability_function<tableaux::rational> stability_function_of(
    const legendre_model<tableaux::rational>& m) {
    using tableaux::rational;
    const bool adjoint = m.rule() == tableaux::construction::adjoint;
    const auto& h = adjoint ? m.integration_matrix() : m.A();
    const int n = is_tridiagonal(h) ? coupled_size(h) : h.size();
    const rational corner = h(0, 0);
    auto p = detail::unscaled(detail::determinant_of_one_minus_z(h, n, corner - 1));
    auto q = detail::unscaled(detail::determinant_of_one_minus_z(h, n, corner));
    if (adjoint) {
        std::swap(p, q);
        p = reflected(p);
        q = reflected(q);
    }
    if (is_tridiagonal(h)) return {std::move(p), std::move(q)};
    return stability_function<rational>::reduced(p, q);
}

STAGECRAFT_INLINE tableaux::rational exponential_error(const stability_function<tableaux::rational>& r,
                                                       int p) {
    using tableaux::rational;
    rational sum = r.numerator[p + 1];  // of P - Q e^z, as Q(0) = 1
    std::vector<rational> inverse_factorials{1};
    for (int k = 1; k <= p + 1; ++k) inverse_factorials.push_back(inverse_factorials.back() / k);
    for (int k = 0; k <= p + 1 && k <= r.denominator.degree(); ++k)
        sum -= r.denominator[k] * inverse_factorials[static_cast<std::size_t>(p + 1 - k)];
    return sum;
}

}  // namespace stagecraft::theory
