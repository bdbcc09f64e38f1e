// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/inner_product.hpp"
#include "stagecraft/theory/dynamics/maximum.hpp"
#include "stagecraft/theory/dynamics/sum_of_squares.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

namespace detail {

/// A rational point with p < 0, looked for among small grid points and random ones.
inline std::optional<std::vector<rational>> point_below_zero(const multinomial& p, int unknowns) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> pick(-20, 20);
    for (const int scale : {10, 1, 100, 1000}) {
        for (int k = 0; k < 500; ++k) {
            std::vector<rational> x;
            for (int i = 0; i < unknowns; ++i)
                x.emplace_back(tableaux::integer(k == 0 ? (i == 0 ? 1 : 0) : pick(random)),
                               tableaux::integer(scale));
            if (p(x) < 0) return x;
        }
    }
    return {};
}

inline std::string text_of(const std::vector<rational>& x) {
    std::string out;
    for (const auto& a : x) out += (out.empty() ? "(" : ", ") + a.str();
    return out + ")";
}

}  // namespace detail

/// dV/dt along the solutions of x' = f(x): grad V . f, as a polynomial.
template <int N, class V, class F>
multinomial orbital_derivative(V&& v, F&& f) {
    state<multinomial, N> x;
    for (int i = 0; i < N; ++i) x[i] = multinomial::unknown(i);
    const multinomial value = v(x);
    const auto right = as_polynomials<N>(f);
    require_autonomous<N>(right);
    multinomial sum;
    for (int i = 0; i < N; ++i) sum += value.derivative(i) * right[i];
    return sum;
}

/// Whether V is a Lyapunov function of x' = f(x) at 0 (lecture, Definition 3.9), V(x) and f polynomial: V(0)
/// = 0, V > 0 elsewhere, dV/dt <= 0. proved by Gram matrices (V minus a multiple of its lowest even powers,
/// and -dV/dt, are sums of squares); refuted with a point where V <= 0 or dV/dt > 0; consistent where neither
/// was found.
template <int N, class V, class F>
verdict lyapunov_function(V&& v, F&& f) {
    state<multinomial, N> x;
    for (int i = 0; i < N; ++i) x[i] = multinomial::unknown(i);
    const multinomial value = v(x), rate = orbital_derivative<N>(v, f);
    if (value.constant() != 0) return verdict::refuted("V(0) = " + value.constant().str());
    if (const auto p = detail::point_below_zero(-rate, N))
        return verdict::refuted("dV/dt = " + rate(*p).str() + " > 0 at " + detail::text_of(*p));
    if (const auto p = detail::point_below_zero(value, N))
        return verdict::refuted("V = " + value(*p).str() + " < 0 at " + detail::text_of(*p));
    // V >= epsilon sum x_i^(2k), 2k its lowest power of x_i alone, is more than V > 0 except at 0
    multinomial lowest;
    for (int i = 0; i < N; ++i) {
        std::optional<int> power;
        for (const auto& [m, a] : value.terms()) {
            const int k = multinomial::exponent(m, i);
            if (static_cast<int>(m.size()) == i + 1 && std::accumulate(m.begin(), m.end(), 0) == k)
                power = std::min(power.value_or(k), k);
        }
        multinomial term(rational(1, 1'000'000));
        for (int k = 0; k < power.value_or(0); ++k) term *= multinomial::unknown(i);
        if (power) lowest += term;
        if (!power || *power % 2 != 0)
            return verdict::refuted("V is not positive on the axis of x" + std::to_string(i + 1));
    }
    if (detail::is_sum_of_squares(value - lowest, N) && detail::is_sum_of_squares(-rate, N))
        return verdict::proved("V and -dV/dt = " + (-rate).str() + " are sums of squares");
    return verdict::consistent("no point found", "no Gram matrix found", "dV/dt = " + rate.str());
}

/// Likewise for any V and f that evaluate in dual intervals, on the shell inner <= |x| <= outer: V > 0 and
/// dV/dt < 0 there.
template <int N, class V, class F>
verdict lyapunov_function_on_shell(V&& v, F&& f, double inner, double outer,
                                   const search_limits& limits = {}) {
    if (!(0 < inner && inner < outer) || !std::isfinite(outer))
        throw std::invalid_argument("shell: needs 0 < inner < outer, finite");
    const auto both = [&](const box<N>& x) {  // the larger of -V and dV/dt
        const interval r = length<N>(x);
        if (r.high() < inner || r.low() > outer) {
            constexpr double out = -std::numeric_limits<double>::infinity();
            return interval(out, out);
        }
        using number = dual<interval, N>;
        state<number, N> d;
        for (int i = 0; i < N; ++i) d[i] = dual_unknown<N>(x[i], i);
        const number value = v(d);
        const box<N> fx = enclosed<N>(f, x);
        interval rate = 0;
        for (int i = 0; i < N; ++i) rate += value.derivatives()[i] * fx[i];
        const interval down = -value.value();
        return interval(std::max(down.low(), rate.low()), std::max(down.high(), rate.high()));
    };
    const auto m = maximise<N>(both, cube<N>(origin<N>(), outer), limits);
    if (m.high < 0) return verdict::proved("V > 0 and dV/dt <= " + std::to_string(m.high) + " on the shell");
    if (m.low > 0)
        return verdict::refuted("V < 0 or dV/dt > 0, " + std::to_string(m.low) + ", at a point of the shell");
    return verdict::consistent("between " + std::to_string(m.low) + " and " + std::to_string(m.high), "0",
                               "not decided on the shell");
}

}  // namespace stagecraft::theory
