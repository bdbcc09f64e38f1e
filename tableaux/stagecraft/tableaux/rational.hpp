// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <compare>
#include <concepts>
#include <iosfwd>
#include <limits>
#include <stagecraft/tableaux/integer.hpp>
#include <stagecraft/tableaux/number_traits.hpp>
#include <string>
#include <utility>

namespace stagecraft::tableaux {

/// An exact rational number of any size. A strong type: no floating-point number converts to it, because
/// a silent 0.1 would be a proof about another tableau. Always in lowest terms, denominator positive. Sums
/// and products keep their greatest common divisors as small as Knuth does (TAOCP 2, section 4.5.1).
class rational {
  public:
    rational() = default;
    template <std::integral I>
    rational(I n) : n_(n) {}                   // NOLINT: integers are rationals
    rational(integer n) : n_(std::move(n)) {}  // NOLINT
    /// n/d. Throws std::domain_error for d = 0.
    rational(integer n, integer d);
    template <std::floating_point F>
    rational(F) = delete;

    const integer& numerator() const& { return n_; }
    const integer& denominator() const& { return d_; }
    integer numerator() && { return std::move(n_); }
    integer denominator() && { return std::move(d_); }

    rational operator-() const;
    rational& operator+=(const rational& o) { return add(o, o.n_); }
    rational& operator-=(const rational& o) { return add(o, -o.n_); }
    rational& operator*=(const rational& o);
    /// Throws std::domain_error for o = 0.
    rational& operator/=(const rational& o);
    friend rational operator+(rational a, const rational& b) { return a += b; }
    friend rational operator-(rational a, const rational& b) { return a -= b; }
    friend rational operator*(rational a, const rational& b) { return a *= b; }
    friend rational operator/(rational a, const rational& b) { return a /= b; }
    friend bool operator==(const rational& a, const rational& b) { return a.n_ == b.n_ && a.d_ == b.d_; }
    friend std::strong_ordering operator<=>(const rational& a, const rational& b) {
        const bool easy = a.d_ == b.d_ || a.n_.sign() != b.n_.sign();
        const int s = easy ? a.n_.compare(b.n_) : integer(a.n_ * b.d_).compare(integer(b.n_ * a.d_));
        return s < 0   ? std::strong_ordering::less
               : s > 0 ? std::strong_ordering::greater
                       : std::strong_ordering::equal;
    }

    /// "p/q", or "p" where q = 1.
    std::string str() const { return d_ == 1 ? n_.str() : n_.str() + "/" + d_.str(); }
    template <class Traits>
    friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                                        const rational& r) {
        out << r.str();
        return out;
    }

    /// The nearest number of a binary floating type (float, double, long double, cpp_bin_float), ties to even: a built-in
    /// type's subnormal numbers included, infinite from half a unit beyond its largest number. Of a decimal type the
    /// quotient of the two parts in that type, good to a few units of its last place.
    template <class Real>
    Real to() const {
        using limits = std::numeric_limits<Real>;
        const integer n = boost::multiprecision::abs(n_);
        if (n == 0) return Real(0);
        const auto longest = static_cast<long>(std::max(msb(n), msb(d_)));
        Real size;
        if constexpr (limits::radix != 2) {
            size = static_cast<Real>(n) / static_cast<Real>(d_);
        } else if (longest < limits::digits) {  // both are numbers of the type: one rounding
            size = static_cast<Real>(n) / static_cast<Real>(d_);
        } else {
            size = nearest_quotient<Real>(n, d_);
        }
        return n_ < 0 ? Real(-size) : size;
    }

  private:
    // n/d > 0: as many bits of the quotient as the type has there, rounded by the remainder.
    template <class Real>
    static Real nearest_quotient(const integer& n, const integer& d) {
        using limits = std::numeric_limits<Real>;
        long top = static_cast<long>(msb(n)) - static_cast<long>(msb(d));  // 2^top <= n/d < 2^(top + 1)
        if (shifted(n, -top) < shifted(d, top)) --top;
        if (top >= limits::max_exponent) return limits::infinity();
        long unit = top - limits::digits + 1;  // of the last place, as a power of two
        if constexpr (std::floating_point<Real>)
            unit = std::max(unit, long{limits::min_exponent} - limits::digits);
        if (top < unit - 1) return Real(0);
        const integer divisor = shifted(d, unit);
        integer quotient, rest;
        divide_qr(shifted(n, -unit), divisor, quotient, rest);
        rest <<= 1;
        if (rest > divisor || (rest == divisor && bit_test(quotient, 0))) ++quotient;
        using std::ldexp;
        return ldexp(static_cast<Real>(quotient), static_cast<int>(unit));
    }
    // x 2^k for k > 0, x else.
    static integer shifted(const integer& x, long k);
    // Divides both by what they share.
    static void cancel(integer& n, integer& d);
    rational& add(const rational& o, const integer& n);

    integer n_ = 0, d_ = 1;
};

inline int sign(const rational& r) { return r < 0 ? -1 : r > 0 ? 1 : 0; }
inline rational abs(const rational& r) { return r < 0 ? -r : r; }

}  // namespace stagecraft::tableaux

template <>
struct Eigen::NumTraits<stagecraft::tableaux::rational>
    : stagecraft::tableaux::number_traits<stagecraft::tableaux::rational> {};

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/rational-inl.hpp"
#endif
