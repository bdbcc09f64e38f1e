// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
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
/// jacobian/dual_functions.hpp has the functions of <cmath>.
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
