// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/multistep.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE verdict consistent_method(const multistep& m) {
    const rational r = m.rho(rational(1)), d = derivative(m.rho)(rational(1)), s = m.sigma(rational(1));
    if (r != 0) return verdict::refuted("rho(1) = " + r.str());
    if (d != s) return verdict::refuted("rho'(1) = " + d.str() + ", sigma(1) = " + s.str());
    return verdict::proved("rho(1) = 0, rho'(1) = sigma(1) = " + s.str());
}

STAGECRAFT_INLINE tableaux::half_plane_count count_by_unit_circle(const polynomial<rational>& p) {
    if (p.is_zero()) throw std::invalid_argument("rho: must not be zero");
    const polynomial<rational> plus{1, 1}, minus{1, -1};
    polynomial<rational> q;
    for (int k = 0; k <= p.degree(); ++k)
        q += polynomial<rational>(p[k]) * power(plus, k) * power(minus, p.degree() - k);
    auto count = count_half_planes(q);
    count.axis += p.degree() - q.degree();  // roots at -1
    return count;
}

STAGECRAFT_INLINE verdict root_condition(const multistep& m) {
    if (m.sigma.degree() > m.rho.degree())
        throw std::invalid_argument("sigma: its degree " + std::to_string(m.sigma.degree()) +
                                    " exceeds that of rho, " + std::to_string(m.rho.degree()) +
                                    ": x at the last point does not occur in the method");
    const auto count = count_by_unit_circle(m.rho);
    if (count.right > 0)
        return verdict::refuted(std::to_string(count.right) + " roots of rho outside the unit circle");
    const auto repeated = gcd(m.rho, derivative(m.rho));
    if (repeated.degree() > 0 && count_by_unit_circle(repeated).axis > 0)
        return verdict::refuted("rho has a multiple root on the unit circle: it divides " +
                                to_string(repeated, "zeta"));
    return verdict::proved(std::to_string(count.left) + " roots inside the unit circle, " +
                           std::to_string(count.axis) + " simple ones on it");
}

STAGECRAFT_INLINE verdict no_multistep_ghosts(const multistep& m) {
    const rational r = m.rho(rational(1)), s = m.sigma(rational(1));
    if (s == 0)
        return verdict::refuted(r == 0 ? "sigma(1) = 0: every constant sequence satisfies the method"
                                       : "sigma(1) = 0: only 0 is stationary");
    if (r != 0)
        return verdict::refuted("rho(1) = " + r.str() + ": stationary where f(x) = rho(1) x/(h sigma(1))");
    return verdict::proved("rho(1) = 0, sigma(1) = " + s.str());
}

namespace detail {
STAGECRAFT_INLINE void require_steps(int k) {
    if (k < 1) throw std::invalid_argument("k: needs at least one step, is " + std::to_string(k));
}
}  // namespace detail

STAGECRAFT_INLINE multistep bdf(int k) {
    detail::require_steps(k);
    multistep m{{}, polynomial<rational>::monomial(k)};
    for (int j = 1; j <= k; ++j)
        m.rho += polynomial<rational>(rational(1, j)) * polynomial<rational>::monomial(k - j) *
                 power(polynomial<rational>{-1, 1}, j);
    return m;
}

namespace detail {
/// x_(n+1) - x_n = integral of the polynomial through f at `points` (in steps, n = 0) over [0, 1].
STAGECRAFT_INLINE polynomial<rational> integrated_weights(const std::vector<int>& points, int shift) {
    polynomial<rational> sigma;
    for (const int i : points) {
        polynomial<rational> lagrange(rational(1));
        for (const int j : points)
            if (j != i) lagrange *= polynomial<rational>{rational(-j, i - j), rational(1, i - j)};
        sigma += polynomial<rational>::monomial(i + shift, integral(lagrange)(rational(1)));
    }
    return sigma;
}
}  // namespace detail

STAGECRAFT_INLINE multistep adams_bashforth(int k) {
    detail::require_steps(k);
    std::vector<int> points;
    for (int j = 1 - k; j <= 0; ++j) points.push_back(j);
    return {polynomial<rational>::monomial(k) - polynomial<rational>::monomial(k - 1),
            detail::integrated_weights(points, k - 1)};
}

STAGECRAFT_INLINE multistep adams_moulton(int k) {
    detail::require_steps(k);
    std::vector<int> points;
    for (int j = 1 - k; j <= 1; ++j) points.push_back(j);
    return {polynomial<rational>::monomial(k) - polynomial<rational>::monomial(k - 1),
            detail::integrated_weights(points, k - 1)};
}

STAGECRAFT_INLINE int order(const multistep& m) {
    if (m.rho.is_zero() && m.sigma.is_zero())
        throw std::invalid_argument("rho, sigma: must not both be zero");
    const int last = std::max(m.rho.degree(), m.sigma.degree());
    for (int q = 0;; ++q) {
        rational left = 0, right = 0;
        for (int j = 0; j <= last; ++j) {
            rational p = 1;  // j^(q-1), and then j^q
            for (int k = 1; k < q; ++k) p *= j;
            if (q > 0) right += rational(q) * m.sigma[j] * p;
            left += m.rho[j] * (q == 0 ? rational(1) : p * rational(j));
        }
        if (left != right) return q - 1;
    }
}

}  // namespace stagecraft::theory
