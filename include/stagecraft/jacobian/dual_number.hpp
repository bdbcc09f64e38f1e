// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace stagecraft {

template <class S, int Width>
class dual_number;

namespace detail {

template <class T>
inline constexpr bool is_dual = false;
template <class S, int Width>
inline constexpr bool is_dual<dual_number<S, Width>> = true;

/// What may stand beside a dual number over S in arithmetic: S itself and the built-in numbers.
template <class T, class S>
concept plain_operand = std::is_same_v<T, S> || std::is_arithmetic_v<T>;

}  // namespace detail

/// A value with its derivatives in Width directions, for forward-mode automatic differentiation (Griewank and
/// Walther, Evaluating Derivatives, chapter 3). S is any real scalar, a dual number too: derivatives of
/// derivatives.
///
/// Every operation returns a dual_number, never an expression that refers to its operands, and every built-in
/// number converts. So right-hand sides and models may keep intermediate results with `auto`, return them, mix
/// in literals of any type and fill matrices by Eigen's comma initialiser (`G << q[0], 1, 0;`), all of which
/// silently give wrong derivatives with Eigen::AutoDiffScalar. Comparisons look at the value alone.
template <class S, int Width>
class dual_number {
  public:
    using scalar = S;
    using derivatives_type = Eigen::Matrix<S, Width, 1>;

    /// The constant 0.
    dual_number() : value_(0) { derivatives_.setConstant(S(0)); }
    /// A constant.
    dual_number(const S& value) : value_(value) { derivatives_.setConstant(S(0)); }
    template <class T>
    requires(std::is_arithmetic_v<T> && !std::is_same_v<T, S>) dual_number(T value) : value_(S(value)) {
        derivatives_.setConstant(S(0));
    }
    /// A value with its derivatives.
    template <class Derived>
    dual_number(const S& value, const Eigen::MatrixBase<Derived>& derivatives)
        : value_(value), derivatives_(derivatives) {}

    const S& value() const { return value_; }
    S& value() { return value_; }
    const derivatives_type& derivatives() const { return derivatives_; }
    derivatives_type& derivatives() { return derivatives_; }

    dual_number& operator+=(const dual_number& b) {
        value_ += b.value_;
        derivatives_ += b.derivatives_;
        return *this;
    }
    dual_number& operator-=(const dual_number& b) {
        value_ -= b.value_;
        derivatives_ -= b.derivatives_;
        return *this;
    }
    dual_number& operator*=(const dual_number& b) { return *this = *this * b; }
    dual_number& operator/=(const dual_number& b) { return *this = *this / b; }

    // Members, which what is compiled may leave undefined without a warning where a right-hand side is refused.
    dual_number operator+() const { return *this; }
    dual_number operator-() const { return {-value_, -derivatives_}; }
    dual_number operator+(const dual_number& b) const {
        return {value_ + b.value_, derivatives_ + b.derivatives_};
    }
    dual_number operator-(const dual_number& b) const {
        return {value_ - b.value_, derivatives_ - b.derivatives_};
    }
    dual_number operator*(const dual_number& b) const {
        return {value_ * b.value_, derivatives_ * b.value_ + b.derivatives_ * value_};
    }
    dual_number operator/(const dual_number& b) const {
        const S inverse = S(1) / b.value_, value = value_ / b.value_;
        return {value, (derivatives_ - b.derivatives_ * value) * inverse};
    }

    // Beside a plain number half of the work goes.
    template <detail::plain_operand<S> T>
    friend dual_number operator+(const dual_number& a, const T& b) {
        return {a.value_ + S(b), a.derivatives_};
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator+(const T& a, const dual_number& b) {
        return {S(a) + b.value_, b.derivatives_};
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator-(const dual_number& a, const T& b) {
        return {a.value_ - S(b), a.derivatives_};
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator-(const T& a, const dual_number& b) {
        return {S(a) - b.value_, -b.derivatives_};
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator*(const dual_number& a, const T& b) {
        const S factor(b);
        return {a.value_ * factor, a.derivatives_ * factor};
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator*(const T& a, const dual_number& b) {
        return b * a;
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator/(const dual_number& a, const T& b) {
        const S divisor(b), inverse = S(1) / divisor;
        return {a.value_ / divisor, a.derivatives_ * inverse};
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator/(const T& a, const dual_number& b) {
        const S value = S(a) / b.value_, slope = -value / b.value_;
        return {value, b.derivatives_ * slope};
    }

    friend bool operator==(const dual_number& a, const dual_number& b) { return a.value_ == b.value_; }
    friend bool operator!=(const dual_number& a, const dual_number& b) { return a.value_ != b.value_; }
    friend bool operator<(const dual_number& a, const dual_number& b) { return a.value_ < b.value_; }
    friend bool operator>(const dual_number& a, const dual_number& b) { return a.value_ > b.value_; }
    friend bool operator<=(const dual_number& a, const dual_number& b) { return a.value_ <= b.value_; }
    friend bool operator>=(const dual_number& a, const dual_number& b) { return a.value_ >= b.value_; }

  private:
    S value_;
    derivatives_type derivatives_;
};

namespace detail {

/// g(x) where g has this value and this slope there.
template <class S, int Width>
dual_number<S, Width> chain(const dual_number<S, Width>& x, const S& value, const S& slope) {
    return {value, x.derivatives() * slope};
}

}  // namespace detail

/// Elementary functions, by the chain rule; the derivatives of sqrt and cbrt at 0 are not finite.
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
/// The slope at 0 is taken to be 1.
template <class S, int W>
dual_number<S, W> abs(const dual_number<S, W>& x) {
    return x.value() < S(0) ? -x : x;
}
template <class S, int W>
dual_number<S, W> fabs(const dual_number<S, W>& x) {
    return abs(x);
}
template <class S, int W>
dual_number<S, W> atan2(const dual_number<S, W>& y, const dual_number<S, W>& x) {
    using std::atan2;
    const S square = x.value() * x.value() + y.value() * y.value();
    return {S(atan2(y.value(), x.value())),
            (y.derivatives() * x.value() - x.derivatives() * y.value()) * S(S(1) / square)};
}
template <class S, int W>
dual_number<S, W> hypot(const dual_number<S, W>& x, const dual_number<S, W>& y) {
    using std::hypot;
    const S length = hypot(x.value(), y.value());
    return {length, (x.derivatives() * x.value() + y.derivatives() * y.value()) * S(S(1) / length)};
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
    return {value, x.derivatives() * by_x + p.derivatives() * by_p};
}

/// The operand with the larger value, the first where they are equal, with its derivatives; min accordingly.
template <class S, int W>
dual_number<S, W> max(const dual_number<S, W>& a, const dual_number<S, W>& b) {
    return a.value() < b.value() ? b : a;
}
template <class S, int W>
dual_number<S, W> min(const dual_number<S, W>& a, const dual_number<S, W>& b) {
    return b.value() < a.value() ? b : a;
}
template <class S, int W, detail::plain_operand<S> T>
dual_number<S, W> max(const dual_number<S, W>& a, const T& b) {
    return max(a, dual_number<S, W>(b));
}
template <class S, int W, detail::plain_operand<S> T>
dual_number<S, W> max(const T& a, const dual_number<S, W>& b) {
    return max(dual_number<S, W>(a), b);
}
template <class S, int W, detail::plain_operand<S> T>
dual_number<S, W> min(const dual_number<S, W>& a, const T& b) {
    return min(a, dual_number<S, W>(b));
}
template <class S, int W, detail::plain_operand<S> T>
dual_number<S, W> min(const T& a, const dual_number<S, W>& b) {
    return min(dual_number<S, W>(a), b);
}

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

}  // namespace stagecraft

namespace Eigen {

template <class S, int W>
struct NumTraits<stagecraft::dual_number<S, W>> : NumTraits<typename NumTraits<S>::Real> {
    using Real = stagecraft::dual_number<S, W>;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = Real;
    enum { RequireInitialization = 1, ReadCost = 1, AddCost = 2 * W, MulCost = 4 * W };
};

template <class S, int W, class BinaryOp>
struct ScalarBinaryOpTraits<stagecraft::dual_number<S, W>, S, BinaryOp> {
    using ReturnType = stagecraft::dual_number<S, W>;
};
template <class S, int W, class BinaryOp>
struct ScalarBinaryOpTraits<S, stagecraft::dual_number<S, W>, BinaryOp> {
    using ReturnType = stagecraft::dual_number<S, W>;
};
template <class S, int W, class T, class BinaryOp>
requires(std::is_arithmetic_v<T> &&
         !std::is_same_v<S, T>) struct ScalarBinaryOpTraits<stagecraft::dual_number<S, W>, T, BinaryOp> {
    using ReturnType = stagecraft::dual_number<S, W>;
};
template <class S, int W, class T, class BinaryOp>
requires(std::is_arithmetic_v<T> &&
         !std::is_same_v<S, T>) struct ScalarBinaryOpTraits<T, stagecraft::dual_number<S, W>, BinaryOp> {
    using ReturnType = stagecraft::dual_number<S, W>;
};

}  // namespace Eigen
