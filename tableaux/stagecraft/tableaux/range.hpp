// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace stagecraft::tableaux {

/// A closed interval [lower, upper] with rational ends: what a file says of a number that it does not give
/// exactly (decimals), or that needs nested surds or more than two. Operations
/// enclose; ends longer than working_bits are rounded outwards, so numbers do not grow. Meant for reading
/// entries, a few operations each; heavy evaluation uses tableaux::ball.
struct range {
    rational lower;
    rational upper;

    /// Significant bits kept of an end point: about 120 decimal digits.
    static constexpr int working_bits = 400;

    rational middle() const { return (lower + upper) / rational(2); }
    rational width() const { return upper - lower; }
    bool contains(const rational& x) const { return lower <= x && x <= upper; }
    friend bool operator==(const range&, const range&) = default;
};

/// floor(log2 |x|) up to one; x nonzero.
inline int binary_exponent(const rational& x) {
    return static_cast<int>(msb(abs(x.numerator()))) - static_cast<int>(msb(x.denominator()));
}

/// Bits of numerator and denominator together.
inline int bit_size(const rational& x) {
    if (x == 0) return 1;
    return static_cast<int>(msb(abs(x.numerator()))) + static_cast<int>(msb(x.denominator())) + 2;
}

inline int bit_size(const quadratic& x) {
    int most = bit_size(x.rational_part());
    for (const auto& surd : x.surds()) most = std::max(most, bit_size(surd.factor));
    return most;
}

/// floor(x).
inline integer floor(const rational& x) {
    const integer n = x.numerator();
    const integer d = x.denominator();
    integer q = n / d;
    if (n < 0 && q * d != n) --q;
    return q;
}

/// x times 2^k.
inline rational scaled(const rational& x, int k) {
    const integer power = integer(1) << (k < 0 ? -k : k);
    return k < 0 ? x / rational(power) : x * rational(power);
}

/// The simplest rational in [low, high], low <= high (the one with the least denominator, and among those the one
/// nearest to 0), by continued fractions.
inline rational simplest_between(const rational& low, const rational& high) {
    if (low <= 0 && high >= 0) return 0;
    if (high < 0) return -simplest_between(-high, -low);
    const integer whole = floor(low);
    if (rational(whole) == low) return low;
    if (rational(whole) + 1 <= high) return rational(whole) + 1;
    return rational(whole) + 1 / simplest_between(1 / (high - rational(whole)), 1 / (low - rational(whole)));
}

/// Largest dyadic number of working_bits bits not above x (x itself where it is short already).
inline rational rounded_down(const rational& x) {
    if (bit_size(x) <= 2 * range::working_bits) return x;
    const int k = range::working_bits - binary_exponent(x);
    return scaled(rational(floor(scaled(x, k))), -k);
}

inline rational rounded_up(const rational& x) { return -rounded_down(-x); }

inline range outward(const rational& lower, const rational& upper) {
    return {rounded_down(lower), rounded_up(upper)};
}

inline range operator-(const range& x) { return {-x.upper, -x.lower}; }
inline range operator+(const range& x, const range& y) {
    return outward(x.lower + y.lower, x.upper + y.upper);
}
inline range operator-(const range& x, const range& y) { return x + -y; }
inline range operator*(const range& x, const range& y) {
    const auto [low, high] =
        std::minmax({x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper});
    return outward(low, high);
}
/// Throws std::domain_error where y contains 0.
inline range operator/(const range& x, const range& y) {
    if (y.contains(0)) throw std::domain_error("division by zero");
    return x * outward(rational(1) / y.upper, rational(1) / y.lower);
}

/// Square root; the negative part of x is outside the domain and cut off. Throws std::domain_error for
/// an x that is negative altogether.
inline range sqrt(const range& x) {
    if (x.upper < 0) throw std::domain_error("square root of a negative number");
    const auto root = [](const rational& r) {  // floor(sqrt(r) 2^k) 2^-k, and the step 2^-k
        if (r <= 0) return range{0, 0};
        const int k = range::working_bits - binary_exponent(r) / 2;
        const integer n = sqrt(floor(scaled(r, 2 * k)));
        return range{scaled(rational(n), -k), scaled(rational(integer(n + 1)), -k)};
    };
    return {root(x.lower).lower, root(x.upper).upper};
}

/// Enclosure of a + b sqrt(d) + ..., the point itself for a rational.
inline range to_range(const quadratic& x) {
    range sum{x.rational_part(), x.rational_part()};
    for (const auto& [factor, d] : x.surds())
        sum = sum + sqrt(range{rational(d), rational(d)}) * range{factor, factor};
    return sum;
}

}  // namespace stagecraft::tableaux
