// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
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

/// The rate kappa of Perron's theorem (lecture, Satz 3.7), rounded up: where <B x, x> <= gamma |x|^2 in the norm of G and
/// |h(x, t)|_2 <= epsilon |x|_2, solutions of x' = B x + h(x, t) satisfy |x(t)| <= e^(kappa t) |x(0)| with kappa = gamma +
/// epsilon eta_2/eta_1, eta_1^2 and eta_2^2 being the least and the largest eigenvalue of G. Throws std::invalid_argument
/// where G is no inner product or epsilon < 0.
double perron_rate(const rational& gamma, const dense<rational>& G, const rational& epsilon);

namespace detail {

/// The largest radius up to `most` (found to five per cent) for which the logarithmic norm of f' in that of G is proved
/// negative, for all t in `time`, on a box around the ball |x - c| <= radius.
template <int N, class F>
attraction largest_ball(F& f, const state<rational, N>& c, const dense<rational>& G, double most,
                        const interval& time) {
    const auto inverse = *tableaux::inverse<rational>(G);
    const logarithmic_norm_bound<N> norm(G);
    const auto rate = [&](double radius) {  // 0 where nothing is proved
        box<N> x;
        for (int i = 0; i < N; ++i) {
            const double side = (interval(radius) * sqrt(interval(inverse(i, i)))).high();
            x[i] = interval(c[i]) + interval(-side, side);
        }
        const auto m = maximise<N>([&](const box<N>& y) { return norm(enclosed_jacobian<N>(f, y, time)); }, x,
                                   {.absolute = 1e-6, .relative = 0.05, .boxes = 2000});
        return m.high < 0 ? -m.high : 0.0;
    };
    double radius = std::min(1e-6, most), next = most;
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

/// The same in the inner product that proves <B x, x> <= gamma |x|^2, gamma = alpha(B)/2, B near f'(c).
template <int N, class F>
attraction ball_around(F& f, const state<rational, N>& c, const dense<rational>& B, double most,
                       const interval& time) {
    if (!(most > 0) || !std::isfinite(most))
        throw std::invalid_argument("most: must be positive and finite, is " + shortest(most));
    const auto alpha = spectral_abscissa(B);
    if (alpha.high >= 0 || alpha.low == 0)
        return {
            verdict::consistent("alpha(f'(c)) >= " + alpha.low.str(), "0",
                                "the linear part decides nothing unless its spectral abscissa is negative"),
            euclidean(N), 0, 0};
    return largest_ball<N>(f, c, inner_product(B, alpha.high / 2), most, time);
}

}  // namespace detail

/// A ball of attraction of an equilibrium c with alpha(f'(c)) < 0 of a polynomial autonomous f (lecture, Satz 3.8): in the
/// inner product that proves <f'(c) x, x> <= gamma |x|^2, gamma = alpha/2, the largest radius up to `most` (found to five
/// per cent) for which the logarithmic norm of f' is proved negative on a box around the ball. consistent with radius 0
/// where alpha(f'(c)) >= 0. Throws std::invalid_argument where f(c) != 0 (c exactly) or f depends on time.
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
    return detail::ball_around<N>(f, c, B, most, interval::whole());
}

/// Likewise for any f(t, x) that evaluates in dual intervals, sin and exp included, for all t in `time`, all times unless
/// said (lecture, Satz 3.7 and 3.8: f(x, t) = B x + h(x, t)). f' is only enclosed at c, and B is the middle of that; what is
/// proved of the ball rests on enclosures alone. That f(c, t) = 0 for all t is the caller's word: refused with
/// std::invalid_argument where an enclosure excludes it. consistent with radius 0 where no ball was proved, so where h
/// is not small near c for all times at once. Throws std::invalid_argument where f' cannot be bounded at c.
template <int N, class F>
attraction attraction_radius_on(F&& f, const state<rational, N>& c, double most,
                                const interval& time = interval::whole()) {
    box<N> point;
    for (int i = 0; i < N; ++i) point[i] = interval(c[i]);
    const auto value = enclosed<N>(f, point, time);
    const auto slope = enclosed_jacobian<N>(f, point, time);
    dense<rational> B(N, N);
    for (int i = 0; i < N; ++i) {
        if (!value[i].contains(0.0)) throw std::invalid_argument("c: f does not vanish there");
        for (int j = 0; j < N; ++j) {
            if (!slope(i, j).bounded())
                throw std::invalid_argument("f: its derivative cannot be bounded at c for all these times");
            B(i, j) = exactly(slope(i, j).middle());
        }
    }
    return detail::ball_around<N>(f, c, B, most, time);
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/lyapunov-inl.hpp"
#endif
