// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/rational.hpp>

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
int binary_exponent(const rational& x);

/// Bits of numerator and denominator together.
int bit_size(const rational& x);

int bit_size(const quadratic& x);

/// floor(x).
integer floor(const rational& x);

/// x times 2^k.
rational scaled(const rational& x, int k);

/// The rational number that a finite double is. Throws std::invalid_argument for an infinity or a NaN.
rational exactly(double x);

/// The simplest rational in [low, high], low <= high (the one with the least denominator, and among those the one
/// nearest to 0), by continued fractions.
rational simplest_between(const rational& low, const rational& high);

/// Largest dyadic number of working_bits bits not above x (x itself where it is short already).
rational rounded_down(const rational& x);

inline rational rounded_up(const rational& x) { return -rounded_down(-x); }

range outward(const rational& lower, const rational& upper);

inline range operator-(const range& x) { return {-x.upper, -x.lower}; }
range operator+(const range& x, const range& y);
inline range operator-(const range& x, const range& y) { return x + -y; }
range operator*(const range& x, const range& y);
/// Throws std::domain_error where y contains 0.
range operator/(const range& x, const range& y);

/// Square root; the negative part of x is outside the domain and cut off. Throws std::domain_error for
/// an x that is negative altogether.
range sqrt(const range& x);

/// Enclosure of a + b sqrt(d) + ..., the point itself for a rational.
range to_range(const quadratic& x);

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/range-inl.hpp"
#endif
