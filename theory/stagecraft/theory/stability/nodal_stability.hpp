// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/rational.hpp"
#include "stagecraft/theory/models/legendre_model.hpp"
#include "stagecraft/theory/stability/schwarz.hpp"
#include "stagecraft/theory/stability/stability_function.hpp"

namespace stagecraft::theory {

namespace detail {

using tableaux::integer;
using tableaux::rational;

// A polynomial as integers over one denominator: one lcm per operation instead of a gcd per coefficient.
struct scaled_polynomial {
    std::vector<integer> numerators;
    integer denominator = 1;
};

// det(I - z H) of the leading block of size n, H upper Hessenberg, by the leading minors d_k:
// d_k = (1 - z h_kk) d_{k-1} - sum_{i<k} z^{k-i+1} h_ik h_{k,k-1} ... h_{i+1,i} d_{i-1}   (k, i from 1).
// O(n^2) operations on integers for a tridiagonal H, O(n^3) for any.
inline scaled_polynomial determinant_of_one_minus_z(const band_matrix<rational>& h, int n,
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

inline tableaux::polynomial<rational> unscaled(const scaled_polynomial& p) {
    std::vector<rational> a;
    for (const integer& n : p.numerators) a.emplace_back(n, p.denominator);
    return tableaux::polynomial<rational>(std::move(a));
}

}  // namespace detail

/// R(z) in lowest terms from the model: det(I - z(H - e_0 e_0^T)) / det(I - z H) with the upper Hessenberg
/// H = A, for D(s) methods by R(z) = 1/R_c(-z) with the collocation method R_c on the same nodes. Where H is
/// tridiagonal its coupled block gives coprime determinants, otherwise common factors are cancelled.
/// O(s^2) integer operations for the families.
inline stability_function<tableaux::rational> stability_function_of(
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

/// C in R(z) - e^z = C z^{p+1} + O(z^{p+2}) for an R with R(z) - e^z = O(z^{p+1}); zero where R is of higher
/// order than p. O(p) operations.
inline tableaux::rational exponential_error(const stability_function<tableaux::rational>& r, int p) {
    using tableaux::rational;
    rational sum = r.numerator[p + 1];  // of P - Q e^z, as Q(0) = 1
    std::vector<rational> inverse_factorials{1};
    for (int k = 1; k <= p + 1; ++k) inverse_factorials.push_back(inverse_factorials.back() / k);
    for (int k = 0; k <= p + 1 && k <= r.denominator.degree(); ++k)
        sum -= r.denominator[k] * inverse_factorials[static_cast<std::size_t>(p + 1 - k)];
    return sum;
}

}  // namespace stagecraft::theory
