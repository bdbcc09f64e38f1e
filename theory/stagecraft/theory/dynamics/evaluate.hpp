// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <vector>

#include "stagecraft/theory/dynamics/interval.hpp"
#include "stagecraft/theory/dynamics/multinomial.hpp"
#include "stagecraft/theory/dynamics/rational_function.hpp"

// One right-hand side f(t, x, out), several arithmetics: at unknowns over the rationals (statements that hold
// everywhere), in intervals (statements on a box), in doubles (measurements).

namespace stagecraft::theory {

template <class T, int N>
using state = Eigen::Matrix<T, N, 1>;

/// f can be called as f(t, x, out) with entries of T; a generic lambda, f(const auto& t, const auto& x,
/// auto& out), can as long as its body uses operations that T has.
template <class F, class T, int N>
concept evaluates_in = requires(F& f, const T& t, const state<T, N>& x, state<T, N>& out) {
    f(t, x, out);
};

/// What f is evaluated in for a statement that is to hold everywhere: it has no other functions than these, which refuse.
template <class T>
concept holds_everywhere = std::same_as<T, multinomial> || std::same_as<T, rational_function>;
template <holds_everywhere T>
T exp(const T&) {
    static_assert(
        stagecraft::detail::never<T>,
        "exp: a statement on all of R^m needs a polynomial f, on the whole line a rational one; give a box");
}
template <holds_everywhere T>
T log(const T&) {
    static_assert(
        stagecraft::detail::never<T>,
        "log: a statement on all of R^m needs a polynomial f, on the whole line a rational one; give a box");
}
template <holds_everywhere T>
T sin(const T&) {
    static_assert(
        stagecraft::detail::never<T>,
        "sin: a statement on all of R^m needs a polynomial f, on the whole line a rational one; give a box");
}
template <holds_everywhere T>
T cos(const T&) {
    static_assert(
        stagecraft::detail::never<T>,
        "cos: a statement on all of R^m needs a polynomial f, on the whole line a rational one; give a box");
}
template <holds_everywhere T>
T sqrt(const T&) {
    static_assert(
        stagecraft::detail::never<T>,
        "sqrt: a statement on all of R^m needs a polynomial f, on the whole line a rational one; give a box");
}

/// f as polynomials in x_0 ... x_(N-1), with the time as unknown x_N.
template <int N, class F>
state<multinomial, N> as_polynomials(F&& f) {
    static_assert(evaluates_in<F, multinomial, N>,
                  "a statement on all of R^m needs f in polynomial arithmetic: take t, x and out as auto");
    state<multinomial, N> x, out;
    for (int i = 0; i < N; ++i) x[i] = multinomial::unknown(i);
    f(multinomial::unknown(N), x, out);
    return out;
}

/// Throws std::invalid_argument where f depends on time.
template <int N>
void require_autonomous(const state<multinomial, N>& f) {
    for (int i = 0; i < N; ++i)
        if (f[i].depends_on(N))
            throw std::invalid_argument("f: depends on time, which this statement does not allow");
}

/// What stands for the time where f must not depend on it: it has no operations.
struct no_time {};

/// A scalar autonomous f as a rational function of x.
template <class F>
rational_function as_rational_function(F&& f) {
    static_assert(
        requires(const state<rational_function, 1>& x, state<rational_function, 1>& out) {
            f(no_time{}, x, out);
        },
        "a statement on the whole line needs a rational f that does not use t: take t, x and out as auto");
    state<rational_function, 1> x(rational_function::x()), out;
    f(no_time{}, x, out);
    return out[0];
}

/// f at one rational point, exactly.
template <int N, class F>
state<rational, N> exact_value(F&& f, const state<rational, N>& x) {
    static_assert(evaluates_in<F, rational, N>,
                  "f is needed in rational arithmetic: take t, x and out as auto");
    state<rational, N> out;
    f(rational(0), x, out);
    return out;
}

/// A box: one interval for each unknown.
template <int N>
using box = state<interval, N>;

/// Throws std::invalid_argument unless the box is bounded (an interval cannot be empty or reversed).
template <int N>
void require_bounded(const box<N>& x) {
    for (int i = 0; i < N; ++i)
        if (!x[i].bounded())
            throw std::invalid_argument("box: side " + std::to_string(i + 1) + " must be bounded");
}

/// Enclosures of f and of its Jacobian on a box, for all times in `time` (the whole line unless said).
template <int N, class F>
box<N> enclosed(F&& f, const box<N>& x, const interval& time = interval::whole()) {
    static_assert(evaluates_in<F, interval, N>,
                  "a statement on a box needs f in intervals: take t, x and out as "
                  "auto and let exp, log, sin, cos, sqrt be found unqualified");
    box<N> out;
    f(time, x, out);
    return out;
}
template <int N, class F>
Eigen::Matrix<interval, N, N> enclosed_jacobian(F&& f, const box<N>& x,
                                                const interval& time = interval::whole()) {
    static_assert(evaluates_in<F, dual<interval, N>, N>,
                  "the Jacobian on a box needs f in dual numbers: take t, x and out as auto");
    Eigen::Matrix<interval, N, N> J;
    automatic_jacobian<interval, N> differentiate(N);
    differentiate(f, time, x, x, J);
    return J;
}

/// The unknown x_i of N, enclosed by `value`, as a dual number.
template <int N>
dual<interval, N> dual_unknown(const interval& value, int i) {
    dual<interval, N> x(value);
    x.derivatives()[i] = 1;
    return x;
}

/// The box [-radius, radius]^N around `centre`.
template <int N>
box<N> cube(const state<rational, N>& centre, double radius) {
    box<N> x;
    for (int i = 0; i < N; ++i) x[i] = interval(centre[i]) + interval(-radius, radius);
    return x;
}

template <int N>
state<rational, N> origin() {
    state<rational, N> c;
    for (int i = 0; i < N; ++i) c[i] = 0;
    return c;
}

/// Euclidean length of all points of a box.
template <int N>
interval length(const box<N>& x) {
    interval sum = 0;
    for (int i = 0; i < N; ++i) sum += square(x[i]);
    return sqrt(sum);
}

template <int N>
box<N> middle(const box<N>& x) {
    box<N> m;
    for (int i = 0; i < N; ++i) m[i] = interval(x[i].middle());
    return m;
}

template <int N>
int widest(const box<N>& x) {
    int k = 0;
    for (int i = 1; i < N; ++i)
        if (x[i].width() > x[k].width()) k = i;
    return k;
}

}  // namespace stagecraft::theory
