// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/range.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE int binary_exponent(const rational& x) {
    return static_cast<int>(msb(abs(x.numerator()))) - static_cast<int>(msb(x.denominator()));
}

STAGECRAFT_INLINE int bit_size(const rational& x) {
    if (x == 0) return 1;
    return static_cast<int>(msb(abs(x.numerator()))) + static_cast<int>(msb(x.denominator())) + 2;
}

STAGECRAFT_INLINE int bit_size(const quadratic& x) {
    int most = bit_size(x.rational_part());
    for (const auto& surd : x.surds()) most = std::max(most, bit_size(surd.factor));
    return most;
}

STAGECRAFT_INLINE integer floor(const rational& x) {
    const integer n = x.numerator();
    const integer d = x.denominator();
    integer q = n / d;
    if (n < 0 && q * d != n) --q;
    return q;
}

STAGECRAFT_INLINE rational scaled(const rational& x, int k) {
    const integer power = integer(1) << (k < 0 ? -k : k);
    return k < 0 ? x / rational(power) : x * rational(power);
}

STAGECRAFT_INLINE rational exactly(double x) {
    if (!std::isfinite(x)) throw std::invalid_argument("exactly: the number must be finite");
    int e = 0;
    const auto m = static_cast<long long>(std::ldexp(std::frexp(x, &e), 53));
    return scaled(rational(m), e - 53);
}

STAGECRAFT_INLINE rational simplest_between(const rational& low, const rational& high) {
    if (low <= 0 && high >= 0) return 0;
    if (high < 0) return -simplest_between(-high, -low);
    const integer whole = floor(low);
    if (rational(whole) == low) return low;
    if (rational(whole) + 1 <= high) return rational(whole) + 1;
    return rational(whole) + 1 / simplest_between(1 / (high - rational(whole)), 1 / (low - rational(whole)));
}

STAGECRAFT_INLINE rational rounded_down(const rational& x) {
    if (bit_size(x) <= 2 * range::working_bits) return x;
    const int k = range::working_bits - binary_exponent(x);
    return scaled(rational(floor(scaled(x, k))), -k);
}

STAGECRAFT_INLINE range outward(const rational& lower, const rational& upper) {
    return {rounded_down(lower), rounded_up(upper)};
}

STAGECRAFT_INLINE range operator+(const range& x, const range& y) {
    return outward(x.lower + y.lower, x.upper + y.upper);
}

STAGECRAFT_INLINE range operator*(const range& x, const range& y) {
    const auto [low, high] =
        std::minmax({x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper});
    return outward(low, high);
}

STAGECRAFT_INLINE range operator/(const range& x, const range& y) {
    if (y.contains(0)) throw std::domain_error("division by zero");
    return x * outward(rational(1) / y.upper, rational(1) / y.lower);
}

STAGECRAFT_INLINE range sqrt(const range& x) {
    if (x.upper < 0) throw std::domain_error("square root of a negative number");
    const auto root = [](const rational& r) {  // floor(sqrt(r) 2^k) 2^-k, and the step 2^-k
        if (r <= 0) return range{0, 0};
        const int k = range::working_bits - binary_exponent(r) / 2;
        const integer n = sqrt(floor(scaled(r, 2 * k)));
        return range{scaled(rational(n), -k), scaled(rational(integer(n + 1)), -k)};
    };
    return {root(x.lower).lower, root(x.upper).upper};
}

STAGECRAFT_INLINE range to_range(const quadratic& x) {
    range sum{x.rational_part(), x.rational_part()};
    for (const auto& [factor, d] : x.surds())
        sum = sum + sqrt(range{rational(d), rational(d)}) * range{factor, factor};
    return sum;
}

}  // namespace stagecraft::tableaux
