// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <stagecraft/tableaux/ball.hpp>
#include <stdexcept>
#include <string>

namespace stagecraft::tableaux {

/// The two ends of a ball as integers times one power of two, exactly.
struct ball_ends {
    integer lower;
    integer upper;
    long exponent;
};

/// Ends of a ball with finite radius.
ball_ends ends(const ball& x);

/// The number n 2^e rounded to the nearest Real (at most 64 binary digits), ties to even.
/// Throws std::range_error beyond Real's normal range.
template <std::floating_point Real>
Real nearest(const integer& n, long e) {
    if (n == 0) return 0;
    constexpr long p = std::numeric_limits<Real>::digits;
    static_assert(p <= 64, "the significand must fit a 64-bit integer");
    integer m = abs(n);
    const long length = static_cast<long>(msb(m)) + 1;
    if (length + e > std::numeric_limits<Real>::max_exponent ||
        length + e < std::numeric_limits<Real>::min_exponent)
        throw std::range_error("round: a number beyond the range of normal floating-point numbers");
    if (const long drop = length - p; drop > 0) {
        const bool half = bit_test(m, static_cast<unsigned>(drop - 1));
        const bool tie = half && static_cast<long>(lsb(m)) == drop - 1;
        m >>= static_cast<unsigned>(drop);
        e += drop;
        if (half && (!tie || bit_test(m, 0))) ++m;
        if (static_cast<long>(msb(m)) == p) {  // carried into the next power of two
            m >>= 1;
            ++e;
        }
    }
    const Real value = std::ldexp(static_cast<Real>(static_cast<std::uint64_t>(m)), static_cast<int>(e));
    return n < 0 ? -value : value;
}

/// Bits of Real's significand; for a decimal type, bits that hold all its digits.
template <class Real>
inline constexpr int significand_bits = std::numeric_limits<Real>::radix == 2
                                            ? std::numeric_limits<Real>::digits
                                            : bits_for_digits(std::numeric_limits<Real>::max_digits10);

/// The Real nearest to every number in the ball, or nothing where its ends round differently or their signs
/// differ. A zero needs an exact ball: no enclosure of positive width proves it. For a class type (a
/// multiprecision float) the midpoint, once it is known beyond its last place.
template <class Real>
std::optional<Real> nearest(const ball& x) {
    if (x.exactly_zero()) return Real(0);
    if (!certainly_nonzero(x)) return {};
    if constexpr (std::floating_point<Real>) {
        const ball_ends e = ends(x);
        const Real low = nearest<Real>(e.lower, e.exponent);
        if (low != nearest<Real>(e.upper, e.exponent)) return {};
        return low;
    } else {
        if (x.radius() > downward(std::ldexp(x.magnitude_below(), -significand_bits<Real> - 2))) return {};
        using std::ldexp;
        return ldexp(static_cast<Real>(integer(x.digits())), static_cast<int>(x.exponent()));
    }
}

/// A positive rational n/d as digits times a power of ten: the nearest integer of exactly `digits` digits.
struct decimal {
    std::string digits;
    int exponent = 0;  ///< of the last digit
    friend bool operator==(const decimal&, const decimal&) = default;
};
decimal nearest_decimal(const integer& n, const integer& d, int digits);

/// Digits and exponent as text: "0.25000", "-12.345", and from 1e-8 downwards "1.2345e-9".
std::string to_text(const decimal& x, bool negative);

/// An exact rational, correctly rounded to `digits` significant decimal digits, ties to even. Zero is "0".
std::string decimal_text(const rational& q, int digits);

/// The decimal to which every number of the ball rounds, or nothing if its ends round differently.
std::optional<std::string> decimal_text(const ball& x, int digits);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/correct_rounding-inl.hpp"
#endif
