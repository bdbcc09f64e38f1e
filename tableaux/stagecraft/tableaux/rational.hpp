// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <compare>
#include <concepts>
#include <functional>
#include <iosfwd>
#include <stagecraft/tableaux/integer.hpp>
#include <stagecraft/tableaux/number_traits.hpp>
#include <stdexcept>
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
    rational(integer n, integer d) : n_(std::move(n)), d_(std::move(d)) {
        if (d_ == 0) throw std::domain_error("rational: zero denominator");
        if (d_ < 0) {
            n_ = -n_;
            d_ = -d_;
        }
        cancel(n_, d_);
    }
    template <std::floating_point F>
    rational(F) = delete;

    const integer& numerator() const& { return n_; }
    const integer& denominator() const& { return d_; }
    integer numerator() && { return std::move(n_); }
    integer denominator() && { return std::move(d_); }

    rational operator-() const {
        rational r = *this;
        r.n_ = -r.n_;
        return r;
    }
    rational& operator+=(const rational& o) { return add(o, o.n_); }
    rational& operator-=(const rational& o) { return add(o, -o.n_); }
    rational& operator*=(const rational& o) {
        integer n = o.n_, d = o.d_;
        cancel(n_, d);
        cancel(n, d_);
        n_ *= n;
        d_ *= d;
        return *this;
    }
    /// Throws std::domain_error for o = 0.
    rational& operator/=(const rational& o) {
        if (o.n_ == 0) throw std::domain_error("rational: division by zero");
        integer n = o.d_, d = o.n_;
        cancel(n_, d);
        cancel(n, d_);
        n_ *= n;
        d_ *= d;
        if (d_ < 0) {
            n_ = -n_;
            d_ = -d_;
        }
        return *this;
    }
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

    /// The value as a floating type (double or a Boost.Multiprecision float), by one division there. Numbers
    /// too long for a built-in type lose what both have beyond 960 bits first: the value does not overflow
    /// with them.
    template <class Real>
    Real to() const {
        integer n = boost::multiprecision::abs(n_), d = d_;
        if constexpr (std::floating_point<Real>) {
            if (n == 0) return Real(0);
            const auto longest = std::max(msb(n), msb(d));
            if (longest > 960) {
                n >>= longest - 960;
                d >>= longest - 960;
            }
        }
        const Real size = static_cast<Real>(n) / static_cast<Real>(d);
        return n_ < 0 ? Real(-size) : size;
    }

  private:
    // Divides both by what they share.
    static void cancel(integer& n, integer& d) {
        if (d == 1 || n == 1) return;
        const integer common = gcd(n, d);
        if (common == 1) return;
        n /= common;
        d /= common;
    }
    rational& add(const rational& o, const integer& n) {
        if (d_ == o.d_) {
            n_ += n;
            cancel(n_, d_);
            return *this;
        }
        integer common = d_ == 1 || o.d_ == 1 ? integer(1) : gcd(d_, o.d_);
        if (common == 1) {
            n_ = n_ * o.d_ + n * d_;
            d_ *= o.d_;
            return *this;
        }
        const integer rest = o.d_ / common;
        d_ /= common;
        n_ = n_ * rest + n * d_;
        cancel(n_, common);
        d_ *= rest * common;
        return *this;
    }

    integer n_ = 0, d_ = 1;
};

inline int sign(const rational& r) { return r < 0 ? -1 : r > 0 ? 1 : 0; }
inline rational abs(const rational& r) { return r < 0 ? -r : r; }

}  // namespace stagecraft::tableaux

template <>
struct Eigen::NumTraits<stagecraft::tableaux::rational>
    : stagecraft::tableaux::number_traits<stagecraft::tableaux::rational> {};
