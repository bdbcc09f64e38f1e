// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <type_traits>

#include <stagecraft/jacobian/dual_number.hpp>

/// The functions of <cmath> that a right-hand side may call with dual numbers, by the chain rule: abs, fabs, sqrt, cbrt,
/// hypot, pow; exp, exp2, expm1, log, log2, log10, log1p; sin, cos, tan, asin, acos, atan, atan2; sinh, cosh, tanh, asinh,
/// acosh, atanh; erf, erfc; floor, ceil, trunc, round, rint, nearbyint, fmod, remainder; max, min, fmax, fmin,
/// copysign, clamp; isfinite, isnan, isinf, signbit. Those of two arguments take a plain number as one of them. All may be
/// written with std:: or without, as for plain numbers. There are no others: tgamma and lgamma, say, need a Jacobian or
/// a right-hand side of plain numbers. Derivatives that do not exist are not finite: those of sqrt and cbrt at 0, of asin at 1.
namespace stagecraft {

namespace detail {

/// g(x) where g has this value and this slope there.
template <class S, int Width>
dual_number<S, Width> chain(const dual_number<S, Width>& x, const S& value, const S& slope) {
    return dual_number<S, Width>::scaled(value, x, slope);
}

/// The derivative of erf, 2 exp(-x^2) / sqrt(pi).
template <class S>
S bell(const S& x) {
    using std::atan;
    using std::exp;
    using std::sqrt;
    const S pi = S(4) * S(atan(S(1)));
    return S(2) * S(exp(S(-x * x))) / S(sqrt(pi));
}

/// The type of two operands, a dual number and another one or a plain number; no type otherwise.
template <class A, class B>
struct dual_among {};
template <class S, int Width>
struct dual_among<dual_number<S, Width>, dual_number<S, Width>> {
    using type = dual_number<S, Width>;
};
template <class S, int Width, plain_operand<S> T>
struct dual_among<dual_number<S, Width>, T> {
    using type = dual_number<S, Width>;
};
template <class S, int Width, plain_operand<S> T>
struct dual_among<T, dual_number<S, Width>> {
    using type = dual_number<S, Width>;
};
template <class A, class B>
using dual_of = typename dual_among<A, B>::type;

}  // namespace detail

/// Of the value alone: derivatives may be infinite where it is finite.
template <class S, int W>
bool isfinite(const dual_number<S, W>& x) {
    return x.value() - x.value() == S(0);
}
template <class S, int W>
bool isnan(const dual_number<S, W>& x) {
    return !(x.value() == x.value());
}
template <class S, int W>
bool isinf(const dual_number<S, W>& x) {
    return !isfinite(x) && !isnan(x);
}
template <class S, int W>
bool signbit(const dual_number<S, W>& x) {
    using std::signbit;
    return signbit(x.value());
}

template <class S, int W>
dual_number<S, W> sqrt(const dual_number<S, W>& x) {
    using std::sqrt;
    const S root = sqrt(x.value());
    return detail::chain<S, W>(x, root, S(1) / (root + root));
}
template <class S, int W>
dual_number<S, W> cbrt(const dual_number<S, W>& x) {
    using std::cbrt;
    const S root = cbrt(x.value());
    return detail::chain<S, W>(x, root, S(1) / (root * root * S(3)));
}
template <class S, int W>
dual_number<S, W> exp(const dual_number<S, W>& x) {
    using std::exp;
    const S e = exp(x.value());
    return detail::chain<S, W>(x, e, e);
}
template <class S, int W>
dual_number<S, W> exp2(const dual_number<S, W>& x) {
    using std::exp2;
    using std::log;
    const S e = exp2(x.value());
    return detail::chain<S, W>(x, e, S(e * S(log(S(2)))));
}
template <class S, int W>
dual_number<S, W> expm1(const dual_number<S, W>& x) {
    using std::exp;
    using std::expm1;
    return detail::chain<S, W>(x, S(expm1(x.value())), S(exp(x.value())));
}
template <class S, int W>
dual_number<S, W> log(const dual_number<S, W>& x) {
    using std::log;
    return detail::chain<S, W>(x, S(log(x.value())), S(S(1) / x.value()));
}
template <class S, int W>
dual_number<S, W> log1p(const dual_number<S, W>& x) {
    using std::log1p;
    return detail::chain<S, W>(x, S(log1p(x.value())), S(S(1) / (S(1) + x.value())));
}
template <class S, int W>
dual_number<S, W> log10(const dual_number<S, W>& x) {
    using std::log;
    return log(x) / S(log(S(10)));
}
template <class S, int W>
dual_number<S, W> log2(const dual_number<S, W>& x) {
    using std::log;
    return log(x) / S(log(S(2)));
}
template <class S, int W>
dual_number<S, W> sin(const dual_number<S, W>& x) {
    using std::cos;
    using std::sin;
    return detail::chain<S, W>(x, S(sin(x.value())), S(cos(x.value())));
}
template <class S, int W>
dual_number<S, W> cos(const dual_number<S, W>& x) {
    using std::cos;
    using std::sin;
    return detail::chain<S, W>(x, S(cos(x.value())), S(-sin(x.value())));
}
template <class S, int W>
dual_number<S, W> tan(const dual_number<S, W>& x) {
    using std::tan;
    const S t = tan(x.value());
    return detail::chain<S, W>(x, t, S(S(1) + t * t));
}
template <class S, int W>
dual_number<S, W> asin(const dual_number<S, W>& x) {
    using std::asin;
    using std::sqrt;
    return detail::chain<S, W>(x, S(asin(x.value())), S(S(1) / sqrt(S(S(1) - x.value() * x.value()))));
}
template <class S, int W>
dual_number<S, W> acos(const dual_number<S, W>& x) {
    using std::acos;
    using std::sqrt;
    return detail::chain<S, W>(x, S(acos(x.value())), S(S(-1) / sqrt(S(S(1) - x.value() * x.value()))));
}
template <class S, int W>
dual_number<S, W> atan(const dual_number<S, W>& x) {
    using std::atan;
    return detail::chain<S, W>(x, S(atan(x.value())), S(S(1) / (S(1) + x.value() * x.value())));
}
template <class S, int W>
dual_number<S, W> sinh(const dual_number<S, W>& x) {
    using std::cosh;
    using std::sinh;
    return detail::chain<S, W>(x, S(sinh(x.value())), S(cosh(x.value())));
}
template <class S, int W>
dual_number<S, W> cosh(const dual_number<S, W>& x) {
    using std::cosh;
    using std::sinh;
    return detail::chain<S, W>(x, S(cosh(x.value())), S(sinh(x.value())));
}
template <class S, int W>
dual_number<S, W> tanh(const dual_number<S, W>& x) {
    using std::tanh;
    const S t = tanh(x.value());
    return detail::chain<S, W>(x, t, S(S(1) - t * t));
}
template <class S, int W>
dual_number<S, W> asinh(const dual_number<S, W>& x) {
    using std::asinh;
    using std::sqrt;
    return detail::chain<S, W>(x, S(asinh(x.value())), S(S(1) / sqrt(S(x.value() * x.value() + S(1)))));
}
template <class S, int W>
dual_number<S, W> acosh(const dual_number<S, W>& x) {
    using std::acosh;
    using std::sqrt;
    const S below = x.value() - S(1), above = x.value() + S(1);
    return detail::chain<S, W>(x, S(acosh(x.value())), S(S(1) / (sqrt(below) * sqrt(above))));
}
template <class S, int W>
dual_number<S, W> atanh(const dual_number<S, W>& x) {
    using std::atanh;
    const S below = S(1) - x.value(), above = S(1) + x.value();
    return detail::chain<S, W>(x, S(atanh(x.value())), S(S(1) / (below * above)));
}
template <class S, int W>
dual_number<S, W> erf(const dual_number<S, W>& x) {
    using std::erf;
    return detail::chain<S, W>(x, S(erf(x.value())), detail::bell(x.value()));
}
template <class S, int W>
dual_number<S, W> erfc(const dual_number<S, W>& x) {
    using std::erfc;
    return detail::chain<S, W>(x, S(erfc(x.value())), S(-detail::bell(x.value())));
}
/// The slope at 0 is taken to be 1.
template <class S, int W>
dual_number<S, W> abs(const dual_number<S, W>& x) {
    return x.value() < S(0) ? -x : x;
}
template <class S, int W>
dual_number<S, W> fabs(const dual_number<S, W>& x) {
    return abs(x);
}
/// Constant between their jumps, where the derivative is taken to be 0 as well.
template <class S, int W>
dual_number<S, W> floor(const dual_number<S, W>& x) {
    using std::floor;
    return S(floor(x.value()));
}
template <class S, int W>
dual_number<S, W> ceil(const dual_number<S, W>& x) {
    using std::ceil;
    return S(ceil(x.value()));
}
template <class S, int W>
dual_number<S, W> trunc(const dual_number<S, W>& x) {
    using std::trunc;
    return S(trunc(x.value()));
}
template <class S, int W>
dual_number<S, W> round(const dual_number<S, W>& x) {
    using std::round;
    return S(round(x.value()));
}
template <class S, int W>
dual_number<S, W> rint(const dual_number<S, W>& x) {
    using std::rint;
    return S(rint(x.value()));
}
template <class S, int W>
dual_number<S, W> nearbyint(const dual_number<S, W>& x) {
    using std::nearbyint;
    return S(nearbyint(x.value()));
}
template <class A, class B, class D = detail::dual_of<A, B>>
D atan2(const A& a, const B& b) {
    using std::atan2;
    using S = typename D::scalar;
    const D &y = a, &x = b;
    const S square = x.value() * x.value() + y.value() * y.value();
    return D::combined(S(atan2(y.value(), x.value())), y, S(x.value() / square), x, S(-y.value() / square));
}
template <class A, class B, class D = detail::dual_of<A, B>>
D hypot(const A& a, const B& b) {
    using std::hypot;
    using S = typename D::scalar;
    const D &x = a, &y = b;
    const S length = hypot(x.value(), y.value());
    return D::combined(length, x, S(x.value() / length), y, S(y.value() / length));
}

/// The length of (x, y, z).
template <class S, int W>
dual_number<S, W> hypot(const dual_number<S, W>& x, const dual_number<S, W>& y, const dual_number<S, W>& z) {
    using std::hypot;
    const S length = hypot(S(hypot(x.value(), y.value())), z.value());
    return dual_number<S, W>::combined(length, x, S(x.value() / length), y, S(y.value() / length)) +
           dual_number<S, W>::scaled(S(0), z, S(z.value() / length));
}

/// The rest of x / y, with the sign of x; between its jumps its derivative is x' - trunc(x / y) y'.
template <class A, class B, class D = detail::dual_of<A, B>>
D fmod(const A& a, const B& b) {
    using std::fmod;
    using std::round;
    using S = typename D::scalar;
    const D &x = a, &y = b;
    const S rest = fmod(x.value(), y.value());
    return D::combined(rest, x, S(1), y, S(-round(S((x.value() - rest) / y.value()))));
}
/// The same with the quotient rounded to the nearest.
template <class A, class B, class D = detail::dual_of<A, B>>
D remainder(const A& a, const B& b) {
    using std::remainder;
    using std::round;
    using S = typename D::scalar;
    const D &x = a, &y = b;
    const S rest = remainder(x.value(), y.value());
    return D::combined(rest, x, S(1), y, S(-round(S((x.value() - rest) / y.value()))));
}
/// |x| with the sign of y.
template <class A, class B, class D = detail::dual_of<A, B>>
D copysign(const A& a, const B& b) {
    const D &x = a, &y = b;
    return signbit(x) == signbit(y) ? x : -x;
}

/// x^p for a plain exponent: p x^(p-1), right for x = 0 and p >= 1 and for negative x with integer p.
template <class S, int W, detail::plain_operand<S> T>
dual_number<S, W> pow(const dual_number<S, W>& x, const T& p) {
    using std::pow;
    if (p == T(0)) return S(1);
    if constexpr (std::is_integral_v<T>)
        return detail::chain<S, W>(x, S(pow(x.value(), p)), S(S(p) * S(pow(x.value(), p - 1))));
    else
        return detail::chain<S, W>(x, S(pow(x.value(), S(p))), S(S(p) * S(pow(x.value(), S(S(p) - S(1))))));
}
template <class S, int W, detail::plain_operand<S> T>
dual_number<S, W> pow(const T& base, const dual_number<S, W>& p) {
    using std::log;
    using std::pow;
    const S b(base), value = pow(b, p.value());
    return detail::chain<S, W>(p, value, S(value * S(log(b))));
}
template <class S, int W>
dual_number<S, W> pow(const dual_number<S, W>& x, const dual_number<S, W>& p) {
    using std::log;
    using std::pow;
    const S value = pow(x.value(), p.value()), by_x = p.value() * S(pow(x.value(), S(p.value() - S(1)))),
            by_p = x.value() == S(0) ? S(0) : S(value * S(log(x.value())));
    return dual_number<S, W>::combined(value, x, by_x, p, by_p);
}

/// The operand with the larger value, the first where they are equal, with its derivatives; min accordingly.
template <class A, class B, class D = detail::dual_of<A, B>>
D max(const A& a, const B& b) {
    return a < b ? D(b) : D(a);
}
template <class A, class B, class D = detail::dual_of<A, B>>
D min(const A& a, const B& b) {
    return b < a ? D(b) : D(a);
}
/// The same, but a NaN is passed over, as by those of <cmath>.
template <class A, class B, class D = detail::dual_of<A, B>>
D fmax(const A& a, const B& b) {
    const D &x = a, &y = b;
    return isnan(x) ? y : isnan(y) ? x : max(x, y);
}
template <class A, class B, class D = detail::dual_of<A, B>>
D fmin(const A& a, const B& b) {
    const D &x = a, &y = b;
    return isnan(x) ? y : isnan(y) ? x : min(x, y);
}
/// x between plain bounds, where it is constant outside of them.
template <class S, int W, detail::plain_operand<S> A, detail::plain_operand<S> B>
dual_number<S, W> clamp(const dual_number<S, W>& x, const A& low, const B& high) {
    return min(max(x, low), high);
}

template <class S, int W>
dual_number<S, W> lgamma(const dual_number<S, W>& x) {
    static_assert(W < 0,
                  "tgamma and lgamma are not differentiated automatically: give the problem a jacobian, or "
                  "write `const Eigen::Vector3d& y` (the type of y0) in place of `const auto& y`");
    return x;
}
template <class S, int W>
dual_number<S, W> tgamma(const dual_number<S, W>& x) {
    static_assert(W < 0,
                  "tgamma and lgamma are not differentiated automatically: give the problem a jacobian, or "
                  "write `const Eigen::Vector3d& y` (the type of y0) in place of `const auto& y`");
    return x;
}

}  // namespace stagecraft

// A generic right-hand side is written for plain numbers first, with std::sin. Strictly, the standard keeps this namespace
// to itself; these names are found there for dual numbers alone, and no other call can mean them.
namespace std {

using stagecraft::abs, stagecraft::fabs, stagecraft::sqrt, stagecraft::cbrt, stagecraft::hypot,
    stagecraft::pow;
using stagecraft::acos, stagecraft::acosh, stagecraft::cos, stagecraft::cosh, stagecraft::tan,
    stagecraft::tanh;
using stagecraft::asin, stagecraft::asinh, stagecraft::sin, stagecraft::sinh, stagecraft::atan,
    stagecraft::atanh;
using stagecraft::atan2, stagecraft::erf, stagecraft::erfc, stagecraft::lgamma, stagecraft::tgamma;
using stagecraft::ceil, stagecraft::floor, stagecraft::nearbyint, stagecraft::rint, stagecraft::round;
using stagecraft::clamp, stagecraft::copysign, stagecraft::fmax, stagecraft::fmin, stagecraft::max,
    stagecraft::min;
using stagecraft::exp, stagecraft::exp2, stagecraft::expm1, stagecraft::fmod, stagecraft::remainder,
    stagecraft::trunc;
using stagecraft::isfinite, stagecraft::isinf, stagecraft::isnan, stagecraft::signbit;
using stagecraft::log, stagecraft::log10, stagecraft::log1p, stagecraft::log2;

}  // namespace std
