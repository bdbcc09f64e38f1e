// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <concepts>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <utility>

namespace stagecraft::tableaux {

using integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

/// An exact rational number of any size. A strong type: no floating-point number converts to it, because
/// a silent 0.1 would be a proof about another tableau. Always in lowest terms, denominator positive.
class rational {
    using raw = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                              boost::multiprecision::et_off>;

  public:
    rational() = default;
    template <std::integral I>
    rational(I n) : value_(n) {}                   // NOLINT: integers are rationals
    rational(integer n) : value_(std::move(n)) {}  // NOLINT
    /// n/d. Throws std::domain_error for d = 0.
    rational(const integer& n, const integer& d)
        : value_(d == 0  ? throw std::domain_error("rational: zero denominator")
                 : d < 0 ? raw(integer(-n), integer(-d))  // Boost 1.74 refuses a negative denominator
                         : raw(n, d)) {}
    template <std::floating_point F>
    rational(F) = delete;

    integer numerator() const { return boost::multiprecision::numerator(value_); }
    integer denominator() const { return boost::multiprecision::denominator(value_); }

    rational operator-() const { return rational(raw(-value_)); }
    rational& operator+=(const rational& o) {
        value_ += o.value_;
        return *this;
    }
    rational& operator-=(const rational& o) {
        value_ -= o.value_;
        return *this;
    }
    rational& operator*=(const rational& o) {
        value_ *= o.value_;
        return *this;
    }
    /// Throws std::domain_error for o = 0.
    rational& operator/=(const rational& o) {
        if (o.value_.is_zero()) throw std::domain_error("rational: division by zero");
        value_ /= o.value_;
        return *this;
    }
    friend rational operator+(rational a, const rational& b) { return a += b; }
    friend rational operator-(rational a, const rational& b) { return a -= b; }
    friend rational operator*(rational a, const rational& b) { return a *= b; }
    friend rational operator/(rational a, const rational& b) { return a /= b; }
    friend bool operator==(const rational& a, const rational& b) { return a.value_ == b.value_; }
    friend std::strong_ordering operator<=>(const rational& a, const rational& b) {
        const int s = a.value_.compare(b.value_);
        return s < 0   ? std::strong_ordering::less
               : s > 0 ? std::strong_ordering::greater
                       : std::strong_ordering::equal;
    }

    /// "p/q", or "p" where q = 1.
    std::string str() const {
        return denominator() == 1 ? numerator().str() : numerator().str() + "/" + denominator().str();
    }
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
        integer n = boost::multiprecision::abs(numerator()), d = denominator();
        if constexpr (std::floating_point<Real>) {
            if (n == 0) return Real(0);
            const auto longest = std::max(msb(n), msb(d));
            if (longest > 960) {
                n >>= longest - 960;
                d >>= longest - 960;
            }
        }
        const Real size = static_cast<Real>(n) / static_cast<Real>(d);
        return value_ < 0 ? Real(-size) : size;
    }

  private:
    explicit rational(raw v) : value_(std::move(v)) {}
    raw value_ = 0;
};

inline int sign(const rational& r) { return r < 0 ? -1 : r > 0 ? 1 : 0; }
inline rational abs(const rational& r) { return r < 0 ? -r : r; }

}  // namespace stagecraft::tableaux

template <>
struct Eigen::NumTraits<stagecraft::tableaux::rational>
    : Eigen::GenericNumTraits<stagecraft::tableaux::rational> {
    using Real = stagecraft::tableaux::rational;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = Real;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 10,
        AddCost = 100,
        MulCost = 100
    };
    static Real epsilon() { return 0; }
    static Real dummy_precision() { return 0; }
    static int digits10() { return 0; }
};
