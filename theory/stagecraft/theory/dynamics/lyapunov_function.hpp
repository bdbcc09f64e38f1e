// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "stagecraft/theory/dynamics/maximum.hpp"
#include "stagecraft/theory/dynamics/sum_of_squares.hpp"
#include "stagecraft/theory/statements/verdict.hpp"

namespace stagecraft::theory {

namespace detail {

/// The part of p of least degree.
multinomial lowest_part(const multinomial& p);

/// What is asked of a polynomial p with p(0) = 0.
enum class sign_asked { not_negative, positive_off_0 };

/// A rational point where p violates what is asked: for a quadratic form an exact decision, else looked for along the
/// directions of its quadratic part at 0, among small grid points and random ones.
std::optional<std::vector<rational>> violating_point(const multinomial& p, int unknowns, sign_asked asked);

/// An i for which p on the axis of x_i starts with an odd power or vanishes; -1 where there is none.
int axis_without_even_power(const multinomial& p, int unknowns);

/// Whether p is proved to be at least epsilon sum_i x_i^(2k_i), 2k_i its lowest power of x_i alone, for some epsilon > 0,
/// which is more than p > 0 off 0. False says nothing.
bool exceeds_powers(const multinomial& p, int unknowns);

std::string text_of(const std::vector<rational>& x);

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
/// = 0, V > 0 elsewhere, dV/dt <= 0. Decided where V and dV/dt are quadratic forms. Else proved by Gram matrices (V
/// minus a multiple of its lowest even powers, and -dV/dt, are sums of squares); refuted with a point other than 0 where
/// V <= 0, or one where dV/dt > 0; consistent where neither was found. (A V that stays bounded as |x| -> oo says nothing of
/// bounded solutions: the lecture's remark after the definition needs V -> oo.)
template <int N, class V, class F>
verdict lyapunov_function(V&& v, F&& f) {
    state<multinomial, N> x;
    for (int i = 0; i < N; ++i) x[i] = multinomial::unknown(i);
    const multinomial value = v(x), rate = orbital_derivative<N>(v, f);
    if (value.constant() != 0) return verdict::refuted("V(0) = " + value.constant().str());
    using detail::sign_asked;
    if (const auto p = detail::violating_point(-rate, N, sign_asked::not_negative))
        return verdict::refuted("dV/dt = " + rate(*p).str() + " > 0 at " + detail::text_of(*p));
    if (const auto p = detail::violating_point(value, N, sign_asked::positive_off_0))
        return verdict::refuted("V = " + value(*p).str() + " <= 0 at " + detail::text_of(*p));
    const auto is_form = [](const multinomial& p) { return p == detail::lowest_part(p) && p.degree() == 2; };
    if (const int odd = detail::axis_without_even_power(value, N); odd >= 0)
        return verdict::refuted("V is not positive on the axis of x" + std::to_string(odd + 1));
    const bool positive = is_form(value) || detail::exceeds_powers(value, N);
    const bool falls = is_form(rate) || detail::is_sum_of_squares(-rate, N);
    if (positive && falls)
        return verdict::proved(is_form(value) && is_form(rate)
                                   ? "V is a positive definite form, -dV/dt = " + (-rate).str() +
                                         " a semidefinite one"
                                   : "V and -dV/dt = " + (-rate).str() + " are sums of squares");
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
    if (m.high < 0) return verdict::proved("V > 0 and dV/dt <= " + shortest(m.high) + " on the shell");
    if (m.low > 0)
        return verdict::refuted("V < 0 or dV/dt > 0, " + shortest(m.low) + ", at a point of the shell");
    return verdict::consistent("between " + shortest(m.low) + " and " + shortest(m.high), "0",
                               "not decided on the shell");
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/lyapunov_function-inl.hpp"
#endif
