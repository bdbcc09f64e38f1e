// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "stagecraft/theory/dynamics/inner_product.hpp"
#include "stagecraft/theory/dynamics/maximum.hpp"
#include "stagecraft/theory/dynamics/sum_of_squares.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

/// The dissipativity inequality <f(x), x - centre> <= alpha - beta |x - centre|^2 (lecture, Definition 1.11):
/// alpha is the least constant for this beta, at most `alpha`, exactly that where `exact`. proved: it holds,
/// everywhere or (`radius` given) where |x - centre| <= radius. refuted: no alpha serves this beta.
template <int N>
struct dissipativity_constants {
    theory::verdict verdict;
    rational alpha, beta;
    state<rational, N> centre;
    bool exact = false;
    std::optional<double> radius{};

    /// Every ball with more than this radius is absorbing for x' = f(x) (lecture, Satz 1.12).
    double absorbing_radius(double epsilon = 0) const {
        require_constants();
        return sqrt(interval(alpha) / interval(beta) + interval(epsilon)).high();
    }
    /// A time after which every solution from |x - centre| <= start has |x - centre|^2 <= alpha/beta +
    /// epsilon (Satz 1.12); 0 where it has from the beginning.
    double absorption_time(double start, double epsilon) const {
        require_constants();
        if (!(start >= 0) || !std::isfinite(start))
            throw std::invalid_argument("start: must be finite and not negative");
        if (!(epsilon > 0)) throw std::invalid_argument("epsilon: must be positive");
        const interval excess = square(interval(start)) - interval(alpha) / interval(beta);
        if (excess.high() <= epsilon) return 0;
        return (log(interval(excess.high()) / epsilon) / (2 * interval(beta))).high();
    }
    /// Throws std::invalid_argument for alpha < 0 or beta <= 0, which no result of a search has.
    void require_constants() const {
        if (alpha < 0) throw std::invalid_argument("alpha: must not be negative, is " + alpha.str());
        if (!(beta > 0)) throw std::invalid_argument("beta: must be positive, is " + beta.str());
    }
};

namespace detail {

void require_beta(const rational& beta);

inline rational not_negative(const rational& a) { return a < 0 ? rational(0) : a; }

/// Encloses the maximum of value(x, x - centre) on |x - centre| <= radius.
template <int N, class Value>
auto maximise_on_ball(const state<rational, N>& centre, double radius, const search_limits& limits,
                      Value&& value) {
    const auto g = [&](const box<N>& x) {
        box<N> d;
        for (int i = 0; i < N; ++i) d[i] = x[i] - interval(centre[i]);
        if (length<N>(d).low() > radius) {
            constexpr double out = -std::numeric_limits<double>::infinity();
            return interval(out, out);
        }
        return value(x, d);
    };
    return maximise<N>(g, cube<N>(centre, radius), limits);
}

/// The supremum of a polynomial of degree 2 at most over R^N, exactly; nothing where it is unbounded.
template <int N>
std::optional<rational> supremum_of_quadratic(const multinomial& q) {
    dense<rational> Q(N, N), b(N, 1);
    std::vector<rational> zero(N, rational(0));
    for (int i = 0; i < N; ++i) {
        b(i, 0) = q.derivative(i).constant();
        for (int j = 0; j < N; ++j) Q(i, j) = q.derivative(i).derivative(j).constant();
    }
    dense<rational> minus = Q;
    for (Eigen::Index i = 0; i < Q.size(); ++i) minus.data()[i] = -Q.data()[i];
    const auto d = tableaux::diagonalise<rational>(minus);  // V (-Q) V^T = diag(pivots)
    if (d.inertia().negative > 0) return {};
    // With x = V^T y: q = c + (V b)^T y - sum pivots y^2/2, each y_k by itself
    rational best = q.constant();
    for (int k = 0; k < N; ++k) {
        rational slope = 0;
        for (int i = 0; i < N; ++i) slope += d.rows(k, i) * b(i, 0);
        if (d.pivots[k] == 0 && slope != 0) return {};
        if (d.pivots[k] != 0) best += slope * slope / (2 * d.pivots[k]);
    }
    return best;
}

}  // namespace detail

/// The least alpha for a given beta, on all of R^N. Decided for a rational f in one unknown (Sturm) and where
/// <f(x), x - centre> has degree 2 at most (L D L^T); consistent else: give a radius. Throws
/// std::invalid_argument for beta <= 0, and where a rational f divides through zero.
template <int N, class F>
dissipativity_constants<N> dissipativity(F&& f, const rational& beta,
                                         const state<rational, N>& centre = origin<N>()) {
    detail::require_beta(beta);
    const auto none = [&](const std::string& why) {
        return dissipativity_constants<N>{verdict::refuted(why), 0, beta, centre};
    };
    const auto found = [&](const rational& a, bool exact) {
        const rational alpha = detail::not_negative(a);
        return dissipativity_constants<N>{verdict::proved("everywhere: alpha = " + alpha.str()), alpha, beta,
                                          centre, exact};
    };
    if constexpr (N == 1) {
        const rational_function d(polynomial<rational>{-centre[0], 1});
        const auto s = supremum_on_line(as_rational_function(f) * d + rational_function(beta) * d * d);
        if (!s) return none("<f(x), x> + beta |x|^2 is unbounded above");
        return found(s->high, s->low == s->high);
    } else {
        const auto p = as_polynomials<N>(f);
        require_autonomous<N>(p);
        multinomial q;
        for (int i = 0; i < N; ++i) {
            const multinomial d = multinomial::unknown(i) - centre[i];
            q += p[i] * d + beta * d * d;
        }
        if (q.degree() > 2)
            return {verdict::consistent("degree " + std::to_string(q.degree()), "2",
                                        "<f(x), x> is not quadratic; give a radius"),
                    0, beta, centre};
        const auto a = detail::supremum_of_quadratic<N>(q);
        if (!a) return none("<f(x), x> + beta |x|^2 is unbounded above");
        return found(*a, true);
    }
}

/// On R^N for all times t >= t0, f polynomial in t and x: alpha = 0, proved where -<f(t, x), x - centre> - beta
/// |x - centre|^2 at t = t0 + s^2 is a sum of squares in s and x (lecture, section 1.1.1); consistent else. Throws
/// std::invalid_argument for beta <= 0.
template <int N, class F>
dissipativity_constants<N> dissipativity_from(F&& f, const rational& beta, const rational& t0,
                                              const state<rational, N>& centre = origin<N>()) {
    detail::require_beta(beta);
    static_assert(evaluates_in<F, multinomial, N>,
                  "a statement for all t >= t0 needs f in polynomial arithmetic: take t, x and out as auto");
    state<multinomial, N> x, out;
    for (int i = 0; i < N; ++i) x[i] = multinomial::unknown(i) + centre[i];
    const multinomial s = multinomial::unknown(N);
    f(t0 + s * s, x, out);
    multinomial rest;
    for (int i = 0; i < N; ++i)
        rest -= out[i] * multinomial::unknown(i) + beta * multinomial::unknown(i) * multinomial::unknown(i);
    const bool holds = detail::is_sum_of_squares(rest, N + 1);
    return {holds ? verdict::proved("for t >= " + t0.str() + ": alpha = 0, by a sum of squares")
                  : verdict::consistent(rest.str(), "no sum of squares found",
                                        "alpha = 0 is not decided; give a radius and a bounded time"),
            0, beta, centre, holds};
}

/// Likewise on the ball |x - centre| <= radius, for any f that evaluates in intervals, at all times in
/// `time`.
template <int N, class F>
dissipativity_constants<N> dissipativity_within(F&& f, const rational& beta, double radius,
                                                const state<rational, N>& centre = origin<N>(),
                                                const search_limits& limits = {},
                                                const interval& time = interval::whole()) {
    detail::require_beta(beta);
    if (!(radius > 0) || !std::isfinite(radius))
        throw std::invalid_argument("radius: must be positive and finite");
    const auto m = detail::maximise_on_ball<N>(centre, radius, limits, [&](const box<N>& x, const box<N>& d) {
        const box<N> y = enclosed<N>(f, x, time);
        interval sum = 0;
        for (int i = 0; i < N; ++i) sum += y[i] * d[i] + interval(beta) * square(d[i]);
        return sum;
    });
    if (!std::isfinite(m.high))
        throw std::invalid_argument(
            "f: cannot be bounded on the ball (division through zero, or dependence on "
            "an unbounded time)");
    const rational alpha = detail::not_negative(exactly(m.high));
    if (m.complete)
        return {verdict::proved("within the radius: alpha = " + shortest(m.high)),
                alpha,
                beta,
                centre,
                false,
                radius};
    return {verdict::consistent("alpha between " + shortest(m.low) + " and " + shortest(m.high),
                                "width " + shortest(limits.relative), "the limit of boxes was reached"),
            alpha,
            beta,
            centre,
            false,
            radius};
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/dissipativity-inl.hpp"
#endif
