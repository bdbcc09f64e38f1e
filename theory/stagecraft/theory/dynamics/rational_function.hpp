// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <optional>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/number_traits.hpp"
#include "stagecraft/tableaux/polynomial.hpp"
#include "stagecraft/tableaux/rational.hpp"

namespace stagecraft::theory {

using tableaux::polynomial;
using tableaux::rational;

/// A quotient of polynomials in one unknown over the rationals, in lowest terms with a monic denominator:
/// what a scalar right-hand side becomes when it is evaluated at the unknown itself. It remembers what was divided by:
/// where a divisor vanishes the expression has no value, though the quotient in lowest terms may have one.
class rational_function {
  public:
    rational_function() : bottom_(rational(1)) {}
    template <std::integral I>
    rational_function(I n) : rational_function(rational(n)) {}               // NOLINT: integers are functions
    rational_function(const rational& q) : top_(q), bottom_(rational(1)) {}  // NOLINT: so are rationals
    template <std::floating_point F>
    rational_function(F) = delete;
    /// top/bottom. Throws std::invalid_argument for bottom = 0.
    explicit rational_function(polynomial<rational> top, const polynomial<rational>& bottom = rational(1))
        : rational_function(std::move(top), bottom, {bottom}) {}
    /// Likewise, where the divisors on the way were these; the zeros of bottom are among theirs.
    rational_function(polynomial<rational> top, polynomial<rational> bottom,
                      const std::vector<polynomial<rational>>& divisors);
    static rational_function x() { return rational_function(polynomial<rational>::x()); }

    const polynomial<rational>& numerator() const { return top_; }
    const polynomial<rational>& denominator() const { return bottom_; }
    /// What was divided by, monic, each once and not constant.
    const std::vector<polynomial<rational>>& divisors() const { return divisors_; }
    /// Value at x. Throws std::domain_error where a divisor vanishes.
    rational operator()(const rational& x) const;

    rational_function operator-() const { return {-top_, bottom_, divisors_}; }
    friend rational_function operator+(const rational_function& a, const rational_function& b) {
        if (a.bottom_ == b.bottom_) return {a.top_ + b.top_, a.bottom_, both(a, b)};
        return {a.top_ * b.bottom_ + b.top_ * a.bottom_, a.bottom_ * b.bottom_, both(a, b)};
    }
    friend rational_function operator-(const rational_function& a, const rational_function& b) {
        return a + -b;
    }
    friend rational_function operator*(const rational_function& a, const rational_function& b) {
        return {a.top_ * b.top_, a.bottom_ * b.bottom_, both(a, b)};
    }
    friend rational_function operator/(const rational_function& a, const rational_function& b) {
        auto divisors = both(a, b);
        divisors.push_back(b.top_);
        return {a.top_ * b.bottom_, a.bottom_ * b.top_, divisors};
    }
    rational_function& operator+=(const rational_function& o) { return *this = *this + o; }
    rational_function& operator-=(const rational_function& o) { return *this = *this - o; }
    rational_function& operator*=(const rational_function& o) { return *this = *this * o; }
    rational_function& operator/=(const rational_function& o) { return *this = *this / o; }
    /// The same quotient in lowest terms.
    friend bool operator==(const rational_function& a, const rational_function& b) {
        return a.top_ == b.top_ && a.bottom_ == b.bottom_;
    }

  private:
    void remember(polynomial<rational> divisor);
    static std::vector<polynomial<rational>> both(const rational_function& a, const rational_function& b);

    polynomial<rational> top_, bottom_;
    std::vector<polynomial<rational>> divisors_;
};

/// Throws std::invalid_argument where r divides by something that has a real zero, also one that cancels.
void require_defined_on_line(const rational_function& r);

rational_function derivative(const rational_function& r);

/// The supremum of a real function: it lies in [low, high], low = high where it is known exactly. It is
/// attained at `point`, or near it where that is not a rational number; `point` is missing where it is a
/// limit at infinity.
struct supremum {
    rational low, high;
    std::optional<rational> point;
};

/// A point where r exceeds `level`, or nothing: exact (Sturm). r without real poles.
std::optional<rational> point_above(const rational_function& r, const rational& level);

/// sup of r over the real line, exact where it is attained at a rational point or at infinity and else to
/// `width`; nothing where r is unbounded above. One Sturm chain of the numerator of r' and one for the proof.
/// Throws std::invalid_argument where r divides through zero.
std::optional<supremum> supremum_on_line(const rational_function& r,
                                         const rational& width = rational(1, 1LL << 40));

}  // namespace stagecraft::theory

template <>
struct Eigen::NumTraits<stagecraft::theory::rational_function>
    : stagecraft::tableaux::number_traits<stagecraft::theory::rational_function> {};

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dynamics/rational_function-inl.hpp"
#endif
