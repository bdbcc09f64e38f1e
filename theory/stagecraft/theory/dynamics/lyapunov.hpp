// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <stdexcept>
#include <vector>

#include "stagecraft/theory/dynamics/linear_stability.hpp"
#include "stagecraft/theory/dynamics/one_sided_lipschitz.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// |x(t) - c| <= e^(-rate t) |x(0) - c| for |x(0) - c| <= radius in the norm of G.
struct attraction {
    theory::verdict verdict;
    dense<rational> G;
    double radius = 0, rate = 0;

    /// All x with |x - c|_2 <= this lie in the ball.
    double euclidean_radius() const;
};

/// A ball of attraction of an equilibrium c with alpha(f'(c)) < 0 (lecture, Satz 3.7 and 3.8): in the inner
/// product that proves <f'(c) x, x> <= gamma |x|^2, gamma = alpha/2, the largest radius up to `most` (found
/// to five per cent) for which the logarithmic norm of f' is proved negative on a box around the ball.
/// consistent with radius 0 where alpha(f'(c)) >= 0. Throws std::invalid_argument where f(c) != 0 (c
/// exactly).
template <int N, class F>
attraction attraction_radius(F&& f, const state<rational, N>& c, double most = 1e3) {
    const auto value = exact_value<N>(f, c);
    for (int i = 0; i < N; ++i)
        if (value[i] != 0) throw std::invalid_argument("c: f does not vanish there");
    std::vector<rational> at(c.data(), c.data() + N);
    dense<rational> B(N, N);
    const auto p = as_polynomials<N>(f);
    require_autonomous<N>(p);
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) B(i, j) = p[i].derivative(j)(at);
    const auto alpha = spectral_abscissa(B);
    if (alpha.high >= 0 || alpha.low == 0)
        return {
            verdict::consistent("alpha(f'(c)) >= " + alpha.low.str(), "0",
                                "the linear part decides nothing unless its spectral abscissa is negative"),
            euclidean(N), 0, 0};
    const auto G = inner_product(B, alpha.high / 2);
    const auto inverse = *tableaux::inverse<rational>(G);
    const detail::logarithmic_norm_bound<N> norm(G);
    const auto rate = [&](double radius) {  // 0 where nothing is proved
        box<N> x;
        for (int i = 0; i < N; ++i) {
            const double side = (interval(radius) * sqrt(interval(inverse(i, i)))).high();
            x[i] = interval(c[i]) + interval(-side, side);
        }
        const auto m = maximise<N>([&](const box<N>& y) { return norm(enclosed_jacobian<N>(f, y)); }, x,
                                   {.absolute = 1e-6, .relative = 0.05, .boxes = 2000});
        return m.high < 0 ? -m.high : 0.0;
    };
    double radius = 1e-6, next = most;
    if (rate(radius) == 0) return {verdict::consistent("0", "1e-6", "no ball was proved"), G, 0, 0};
    if (rate(next) == 0) {
        while (next > 1.05 * radius) {
            const double middle = std::sqrt(radius * next);
            (rate(middle) > 0 ? radius : next) = middle;
        }
    } else {
        radius = next;
    }
    return {verdict::proved("contractive on the ball of radius " + shortest(radius) + " in the norm of G"), G,
            radius, rate(radius)};
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/lyapunov-inl.hpp"
#endif
