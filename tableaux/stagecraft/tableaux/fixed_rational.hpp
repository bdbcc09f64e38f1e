// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <compare>
#include <concepts>
#include <stdexcept>
#include <string>

namespace stagecraft::tableaux {

__extension__ using int128 = __int128;

/// An exact rational over 128-bit integers for proofs at compile time. Every operation is checked: overflow
/// is a compile error in a constant expression and std::overflow_error at run time; numbers never wrap
/// around. Always in lowest terms, denominator positive. No floating-point number converts to it.
class fixed_rational {
  public:
    constexpr fixed_rational()
        : numerator_(0), denominator_(1) {}  // not trivial: clang 14's constexpr vector
    template <std::integral I>
    constexpr fixed_rational(I n) : numerator_(n), denominator_(1) {}  // NOLINT: integers are rationals
    explicit constexpr fixed_rational(int128 n) : numerator_(n), denominator_(1) {}
    /// n/d. Throws std::domain_error for d = 0.
    constexpr fixed_rational(int128 n, int128 d) : numerator_(n), denominator_(d) {
        if (d == 0) throw std::domain_error("fixed_rational: zero denominator");
        if (d < 0) {
            numerator_ = negated(n);
            denominator_ = negated(d);
        }
        const int128 g = gcd(numerator_, denominator_);
        numerator_ /= g;
        denominator_ /= g;
    }
    template <std::floating_point F>
    fixed_rational(F) = delete;

    constexpr int128 numerator() const { return numerator_; }
    constexpr int128 denominator() const { return denominator_; }

    constexpr fixed_rational operator-() const { return lowest(negated(numerator_), denominator_); }
    // Compilers spend most of a compile-time proof in these, so zeros return early and no call is wasted.
    constexpr fixed_rational& operator+=(const fixed_rational& o) {
        if (o.numerator_ == 0) return *this;
        if (numerator_ == 0) return *this = o;
        if (denominator_ == o.denominator_) {
            int128 sum = 0;
            if (__builtin_add_overflow(numerator_, o.numerator_, &sum)) overflow();
            const int128 common = gcd(sum, denominator_);
            numerator_ = sum / common;
            denominator_ /= common;
            return *this;
        }
        const int128 g = gcd(denominator_, o.denominator_);
        int128 left = 0, right = 0, sum = 0;
        if (__builtin_mul_overflow(numerator_, o.denominator_ / g, &left) ||
            __builtin_mul_overflow(o.numerator_, denominator_ / g, &right) ||
            __builtin_add_overflow(left, right, &sum))
            overflow();
        const int128 h = gcd(sum, g);  // all that the sum can share with the common denominator
        int128 d = 0;
        if (__builtin_mul_overflow(denominator_ / g, o.denominator_ / h, &d)) overflow();
        numerator_ = sum / h;
        denominator_ = d;
        return *this;
    }
    constexpr fixed_rational& operator-=(const fixed_rational& o) {
        return o.numerator_ == 0 ? *this : *this += -o;
    }
    constexpr fixed_rational& operator*=(const fixed_rational& o) {
        if (numerator_ == 0) return *this;
        if (o.numerator_ == 0) return *this = o;
        const int128 g = gcd(numerator_, o.denominator_);
        const int128 h = gcd(o.numerator_, denominator_);
        int128 n = 0, d = 0;
        if (__builtin_mul_overflow(numerator_ / g, o.numerator_ / h, &n) ||
            __builtin_mul_overflow(denominator_ / h, o.denominator_ / g, &d))
            overflow();
        numerator_ = n;
        denominator_ = d;
        return *this;
    }
    /// Throws std::domain_error for o = 0.
    constexpr fixed_rational& operator/=(const fixed_rational& o) {
        if (o.numerator_ == 0) throw std::domain_error("fixed_rational: division by zero");
        if (numerator_ == 0) return *this;
        const int128 g = gcd(o.numerator_, numerator_ < 0 ? negated(numerator_) : numerator_);
        const int128 h = gcd(denominator_, o.denominator_);
        int128 n = 0, d = 0;
        if (__builtin_mul_overflow(numerator_ / g, o.denominator_ / h, &n) ||
            __builtin_mul_overflow(denominator_ / h, o.numerator_ / g, &d))
            overflow();
        numerator_ = d < 0 ? negated(n) : n;
        denominator_ = d < 0 ? negated(d) : d;
        return *this;
    }
    friend constexpr fixed_rational operator+(fixed_rational a, const fixed_rational& b) { return a += b; }
    friend constexpr fixed_rational operator-(fixed_rational a, const fixed_rational& b) { return a -= b; }
    friend constexpr fixed_rational operator*(fixed_rational a, const fixed_rational& b) { return a *= b; }
    friend constexpr fixed_rational operator/(fixed_rational a, const fixed_rational& b) { return a /= b; }
    friend constexpr bool operator==(const fixed_rational&, const fixed_rational&) = default;
    friend constexpr std::strong_ordering operator<=>(const fixed_rational& a, const fixed_rational& b) {
        const int128 g = gcd(a.denominator_, b.denominator_);
        int128 left = 0, right = 0;
        if (__builtin_mul_overflow(a.numerator_, b.denominator_ / g, &left) ||
            __builtin_mul_overflow(b.numerator_, a.denominator_ / g, &right))
            overflow();
        return left < right   ? std::strong_ordering::less
               : left > right ? std::strong_ordering::greater
                              : std::strong_ordering::equal;
    }

    /// "p/q", or "p" where q = 1.
    std::string str() const;
    template <class Traits>
    friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                                        const fixed_rational& r) {
        out << r.str();
        return out;
    }

  private:
    static constexpr fixed_rational lowest(int128 n, int128 d) {  // n, d known to be in lowest terms, d > 0
        fixed_rational r;
        r.numerator_ = n;
        r.denominator_ = d;
        return r;
    }
    static constexpr int128 gcd(int128 a, int128 b) {  // b > 0 in every use, so the result is positive
        while (b > 1) {
            const int128 r = a % b;
            a = b;
            b = r < 0 ? -r : r;
        }
        return b == 1 ? 1 : a;
    }
    static constexpr int128 negated(int128 a) {
        int128 r = 0;
        if (__builtin_sub_overflow(int128{0}, a, &r)) overflow();
        return r;
    }
    [[noreturn]] static void overflow() { throw std::overflow_error("fixed_rational: more than 127 bits"); }
    static std::string decimal(int128 n);

    int128 numerator_;
    int128 denominator_;
};

constexpr int sign(const fixed_rational& r) { return r.numerator() < 0 ? -1 : r.numerator() > 0 ? 1 : 0; }
constexpr fixed_rational abs(const fixed_rational& r) { return sign(r) < 0 ? -r : r; }

namespace literals {
/// 1/15_q is the rational 1/15: the literal is an exact integer, and so is whatever is made from it.
consteval fixed_rational operator""_q(unsigned long long n) { return fixed_rational(n); }
}  // namespace literals

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/fixed_rational-inl.hpp"
#endif
