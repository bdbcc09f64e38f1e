// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <iosfwd>
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

/// What may stand beside a dual number over S in arithmetic: S itself, the built-in numbers, and the exact ones that an
/// enclosure S is made for (S::exact_number).
template <class T, class S>
concept plain_operand = std::is_same_v<T, S> || std::is_arithmetic_v<T> || requires {
    requires std::is_same_v<T, typename S::exact_number>;
};

}  // namespace detail

/// A value with its derivatives in Width directions, for forward-mode automatic differentiation (Griewank and
/// Walther, Evaluating Derivatives, chapter 3). S is any real scalar, a dual number too: derivatives of
/// derivatives.
///
/// Every operation returns a dual_number, never an expression that refers to its operands, and every built-in
/// number converts. So right-hand sides and models may keep intermediate results with `auto`, return them, mix
/// in literals of any type and fill matrices by Eigen's comma initialiser (`G << q[0], 1, 0;`), all of which
/// silently give wrong derivatives with Eigen::AutoDiffScalar. Comparisons, and casts to whole numbers, look at the value
/// alone.
/// jacobian/dual_functions.hpp has the functions of <cmath>.
template <class S, int Width>
class dual_number {
  public:
    using scalar = S;
    using derivatives_type = Eigen::Matrix<S, Width, 1>;

    /// The constant 0.
    dual_number() : dual_number(S(0)) {}
    /// A constant.
    dual_number(const S& value) : value_(value) {
        for (int i = 0; i < Width; ++i) slope(i) = S(0);
    }
    template <class T>
    requires(std::is_arithmetic_v<T> && !std::is_same_v<T, S>) dual_number(T value) : dual_number(S(value)) {}
    /// A value with its derivatives.
    dual_number(const S& value, const derivatives_type& derivatives)
        : value_(value), derivatives_(derivatives) {}
    /// A value with the derivatives a x.
    static dual_number scaled(const S& value, const dual_number& a, const S& x) {
        dual_number r(value, no_slopes());
        if constexpr (wide)
            r.derivatives_ = a.derivatives_ * x;
        else
            for (int i = 0; i < Width; ++i) r.slope(i) = a.slope(i) * x;
        return r;
    }
    /// A value with the derivatives a x + b y.
    static dual_number combined(const S& value, const dual_number& a, const S& x, const dual_number& b,
                                const S& y) {
        dual_number r(value, no_slopes());
        if constexpr (wide)
            r.derivatives_ = a.derivatives_ * x + b.derivatives_ * y;
        else
            for (int i = 0; i < Width; ++i) r.slope(i) = a.slope(i) * x + b.slope(i) * y;
        return r;
    }

    /// To an integer or a bool, which are constant between their jumps, as floor(x) is.
    template <class T>
    requires std::is_arithmetic_v<T>
    explicit operator T() const {
        static_assert(std::is_integral_v<T>,
                      "a right-hand side with `const auto& y` is differentiated by calling it with dual "
                      "numbers, which no double holds: keep what follows from y as `auto k = y[0];`, vectors "
                      "as `std::decay_t<decltype(y)> g = y;`, or write `const Eigen::Vector3d& y`, with the "
                      "type of y0");
        return static_cast<T>(value_);
    }

    // Where a number is taken for a vector, or the other way round. The types are deduced, so that this is said before
    // anything else; that of operator[] deduces from no such member, so that nothing is said of the expression around it.
    template <class I>
    auto operator[](const I& i) const {
        static_assert(!sizeof(I),
                      "a number has no components: where this is the state, the arguments stand in another "
                      "order; a right-hand side is called as f(t, y, out), conditions as r(left, right, "
                      "out), and both as two_point(f, r)");
        return i.of_a_number;
    }
    template <class Vector>
    requires(!std::is_convertible_v<const Vector&, dual_number>) auto operator=(
        const Eigen::EigenBase<Vector>&) {
        static_assert(
            !sizeof(Vector),
            "a component is one number, and what is assigned to it a vector or a matrix of Eigen's: "
            "take one component of that, p[0], say");
        return dual_number(*this);
    }

    const S& value() const { return value_; }
    S& value() { return value_; }
    const derivatives_type& derivatives() const { return derivatives_; }
    derivatives_type& derivatives() { return derivatives_; }

    dual_number& operator+=(const dual_number& b) {
        value_ += b.value_;
        if constexpr (wide)
            derivatives_ += b.derivatives_;
        else
            for (int i = 0; i < Width; ++i) slope(i) += b.slope(i);
        return *this;
    }
    dual_number& operator-=(const dual_number& b) {
        value_ -= b.value_;
        if constexpr (wide)
            derivatives_ -= b.derivatives_;
        else
            for (int i = 0; i < Width; ++i) slope(i) -= b.slope(i);
        return *this;
    }
    dual_number& operator*=(const dual_number& b) { return *this = *this * b; }
    dual_number& operator/=(const dual_number& b) { return *this = *this / b; }

    // Members, which what is compiled may leave undefined without a warning where a right-hand side is refused.
    dual_number operator+() const { return *this; }
    dual_number operator-() const { return scaled(-value_, *this, S(-1)); }
    dual_number operator+(const dual_number& b) const {
        dual_number r(*this);
        return r += b;
    }
    dual_number operator-(const dual_number& b) const {
        dual_number r(*this);
        return r -= b;
    }
    dual_number operator*(const dual_number& b) const {
        return combined(value_ * b.value_, *this, b.value_, b, value_);
    }
    dual_number operator/(const dual_number& b) const {
        const S inverse = S(1) / b.value_, value = value_ / b.value_;
        return combined(value, *this, inverse, b, -value * inverse);
    }

    // Beside a plain number half of the work goes.
    template <detail::plain_operand<S> T>
    friend dual_number operator+(const dual_number& a, const T& b) {
        dual_number r(a);
        r.value_ += S(b);
        return r;
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator+(const T& a, const dual_number& b) {
        return b + a;
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator-(const dual_number& a, const T& b) {
        dual_number r(a);
        r.value_ -= S(b);
        return r;
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator-(const T& a, const dual_number& b) {
        return scaled(S(a) - b.value_, b, S(-1));
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator*(const dual_number& a, const T& b) {
        const S factor(b);
        return scaled(a.value_ * factor, a, factor);
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator*(const T& a, const dual_number& b) {
        return b * a;
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator/(const dual_number& a, const T& b) {
        const S divisor(b);
        return scaled(a.value_ / divisor, a, S(1) / divisor);
    }
    template <detail::plain_operand<S> T>
    friend dual_number operator/(const T& a, const dual_number& b) {
        const S value = S(a) / b.value_;
        return scaled(value, b, -value / b.value_);
    }

    friend bool operator==(const dual_number& a, const dual_number& b) { return a.value_ == b.value_; }
    friend bool operator!=(const dual_number& a, const dual_number& b) { return a.value_ != b.value_; }
    friend bool operator<(const dual_number& a, const dual_number& b) { return a.value_ < b.value_; }
    friend bool operator>(const dual_number& a, const dual_number& b) { return a.value_ > b.value_; }
    friend bool operator<=(const dual_number& a, const dual_number& b) { return a.value_ <= b.value_; }
    friend bool operator>=(const dual_number& a, const dual_number& b) { return a.value_ >= b.value_; }

  private:
    // Few derivatives, and numbers that are dual themselves, are plain loops, which the compiler unrolls: every expression
    // of Eigen's takes it 10 ms for every scalar and width. Many are left to Eigen, which unrolls them at -O2 as well.
    static constexpr bool wide = std::is_floating_point_v<S> && Width > 8;
    struct no_slopes {};
    dual_number(const S& value, no_slopes) : value_(value) {}
    S& slope(int i) { return derivatives_.data()[i]; }
    const S& slope(int i) const { return derivatives_.data()[i]; }

    S value_;
    derivatives_type derivatives_;
};

/// Prints the value.
template <class Traits, class S, int Width>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                             const dual_number<S, Width>& x) {
    return out << x.value();
}

}  // namespace stagecraft

/// That of the values.
template <class S, int Width>
struct std::numeric_limits<stagecraft::dual_number<S, Width>> : std::numeric_limits<S> {};

namespace Eigen {

namespace internal {

/// Plain numbers := dual ones, which would lose their derivatives.
template <class S, int W>
struct assign_op<S, stagecraft::dual_number<S, W>> {
    static_assert(
        !sizeof(S),
        "a right-hand side with `const auto& y` is differentiated by calling it with dual numbers, "
        "which no vector of doubles holds: keep what follows from y as `auto k = y[0];`, vectors as "
        "`std::decay_t<decltype(y)> g = y;`, or write `const Eigen::Vector3d& y`, with the type of "
        "y0");
    void assignCoeff(S&, const stagecraft::dual_number<S, W>&) const {}
};

}  // namespace internal

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
