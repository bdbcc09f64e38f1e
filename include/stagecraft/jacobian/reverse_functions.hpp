// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/jacobian/dual_functions.hpp>
#include <stagecraft/jacobian/reverse_number.hpp>

/// The functions of <cmath> that dual_functions.hpp has, for reverse_number, by the slopes that dual numbers give.
namespace stagecraft {

namespace detail {

/// f(x) on the tape of x; f is called with a dual number.
template <class S, class F>
reverse_number<S> recorded(const reverse_number<S>& x, const F& f) {
    dual_number<S, 1> at(x.value());
    at.derivatives()[0] = S(1);
    const dual_number<S, 1> r = f(at);
    return reverse_number<S>::result(r.value(), x, r.derivatives()[0]);
}

/// The type of two operands, a reverse number and another one or a plain number; no type otherwise.
template <class A, class B>
struct reverse_among {};
template <class S>
struct reverse_among<reverse_number<S>, reverse_number<S>> {
    using type = reverse_number<S>;
};
template <class S, plain_operand<S> T>
struct reverse_among<reverse_number<S>, T> {
    using type = reverse_number<S>;
};
template <class S, plain_operand<S> T>
struct reverse_among<T, reverse_number<S>> {
    using type = reverse_number<S>;
};
template <class A, class B>
using reverse_of = typename reverse_among<A, B>::type;

/// The operand in direction k of two, or as it is where it is a plain number.
template <class S>
dual_number<S, 2> in_direction(const reverse_number<S>& x, int k) {
    dual_number<S, 2> at(x.value());
    at.derivatives()[k] = S(1);
    return at;
}
template <class T>
const T& in_direction(const T& x, int) {
    return x;
}
/// f(a, b) on their tape.
template <class R, class A, class B, class F>
R recorded(const A& a, const B& b, const F& f) {
    const auto r = f(in_direction(a, 0), in_direction(b, 1));
    return R::result(r.value(), R(a), r.derivatives()[0], R(b), r.derivatives()[1]);
}

}  // namespace detail

template <class S>
bool isfinite(const reverse_number<S>& x) {
    return x.value() - x.value() == S(0);
}
template <class S>
bool isnan(const reverse_number<S>& x) {
    return !(x.value() == x.value());
}
template <class S>
bool isinf(const reverse_number<S>& x) {
    return !isfinite(x) && !isnan(x);
}
template <class S>
bool signbit(const reverse_number<S>& x) {
    using std::signbit;
    return signbit(x.value());
}

template <class S>
reverse_number<S> sqrt(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return sqrt(u); });
}
template <class S>
reverse_number<S> cbrt(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return cbrt(u); });
}
template <class S>
reverse_number<S> exp(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return exp(u); });
}
template <class S>
reverse_number<S> exp2(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return exp2(u); });
}
template <class S>
reverse_number<S> expm1(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return expm1(u); });
}
template <class S>
reverse_number<S> log(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return log(u); });
}
template <class S>
reverse_number<S> log1p(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return log1p(u); });
}
template <class S>
reverse_number<S> log10(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return log10(u); });
}
template <class S>
reverse_number<S> log2(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return log2(u); });
}
template <class S>
reverse_number<S> sin(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return sin(u); });
}
template <class S>
reverse_number<S> cos(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return cos(u); });
}
template <class S>
reverse_number<S> tan(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return tan(u); });
}
template <class S>
reverse_number<S> asin(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return asin(u); });
}
template <class S>
reverse_number<S> acos(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return acos(u); });
}
template <class S>
reverse_number<S> atan(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return atan(u); });
}
template <class S>
reverse_number<S> sinh(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return sinh(u); });
}
template <class S>
reverse_number<S> cosh(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return cosh(u); });
}
template <class S>
reverse_number<S> tanh(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return tanh(u); });
}
template <class S>
reverse_number<S> asinh(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return asinh(u); });
}
template <class S>
reverse_number<S> acosh(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return acosh(u); });
}
template <class S>
reverse_number<S> atanh(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return atanh(u); });
}
template <class S>
reverse_number<S> erf(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return erf(u); });
}
template <class S>
reverse_number<S> erfc(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return erfc(u); });
}
template <class S>
reverse_number<S> abs(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return abs(u); });
}
template <class S>
reverse_number<S> fabs(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return fabs(u); });
}
template <class S>
reverse_number<S> floor(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return floor(u); });
}
template <class S>
reverse_number<S> ceil(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return ceil(u); });
}
template <class S>
reverse_number<S> trunc(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return trunc(u); });
}
template <class S>
reverse_number<S> round(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return round(u); });
}
template <class S>
reverse_number<S> rint(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return rint(u); });
}
template <class S>
reverse_number<S> nearbyint(const reverse_number<S>& x) {
    return detail::recorded(x, [](const auto& u) { return nearbyint(u); });
}
template <class A, class B>
detail::reverse_of<A, B> atan2(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(
        a, b, [](const auto& u, const auto& v) { return atan2(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> hypot(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(
        a, b, [](const auto& u, const auto& v) { return hypot(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> fmod(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(
        a, b, [](const auto& u, const auto& v) { return fmod(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> remainder(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(
        a, b, [](const auto& u, const auto& v) { return remainder(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> copysign(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(
        a, b, [](const auto& u, const auto& v) { return copysign(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> pow(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(a, b,
                                                      [](const auto& u, const auto& v) { return pow(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> max(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(a, b,
                                                      [](const auto& u, const auto& v) { return max(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> min(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(a, b,
                                                      [](const auto& u, const auto& v) { return min(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> fmax(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(
        a, b, [](const auto& u, const auto& v) { return fmax(u, v); });
}
template <class A, class B>
detail::reverse_of<A, B> fmin(const A& a, const B& b) {
    return detail::recorded<detail::reverse_of<A, B>>(
        a, b, [](const auto& u, const auto& v) { return fmin(u, v); });
}
template <class S>
reverse_number<S> hypot(const reverse_number<S>& x, const reverse_number<S>& y, const reverse_number<S>& z) {
    return hypot(hypot(x, y), z);
}
template <class S, detail::plain_operand<S> A, detail::plain_operand<S> B>
reverse_number<S> clamp(const reverse_number<S>& x, const A& low, const B& high) {
    return min(max(x, low), high);
}

}  // namespace stagecraft

// As in dual_functions.hpp.
namespace std {

using stagecraft::asin, stagecraft::acos, stagecraft::atan, stagecraft::sinh, stagecraft::cosh,
    stagecraft::tanh;
using stagecraft::asinh, stagecraft::acosh, stagecraft::atanh, stagecraft::erf, stagecraft::erfc,
    stagecraft::abs;
using stagecraft::fabs, stagecraft::floor, stagecraft::ceil, stagecraft::trunc, stagecraft::round,
    stagecraft::rint;
using stagecraft::isfinite, stagecraft::isinf, stagecraft::isnan, stagecraft::signbit;
using stagecraft::log1p, stagecraft::log10, stagecraft::log2, stagecraft::sin, stagecraft::cos,
    stagecraft::tan;
using stagecraft::nearbyint, stagecraft::atan2, stagecraft::hypot, stagecraft::fmod, stagecraft::remainder,
    stagecraft::copysign;
using stagecraft::pow, stagecraft::max, stagecraft::min, stagecraft::fmax, stagecraft::fmin,
    stagecraft::clamp;
using stagecraft::sqrt, stagecraft::cbrt, stagecraft::exp, stagecraft::exp2, stagecraft::expm1,
    stagecraft::log;

}  // namespace std
