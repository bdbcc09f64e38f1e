// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stagecraft/tableaux/ball.hpp>

namespace stagecraft::tableaux {

/// An enclosure of a complex number: real and imaginary part in a ball each.
struct complex_ball {
    ball re;
    ball im;

    complex_ball midpoint() const { return {re.midpoint(), im.midpoint()}; }
    complex_ball with_bits(int bits) const { return {re.with_bits(bits), im.with_bits(bits)}; }
    complex_ball conjugate() const { return {re, -im}; }
    /// All points within r of this set.
    complex_ball widened(bound r) const { return {re.widened(r), im.widened(r)}; }
    bound upper_magnitude() const { return upward(re.upper_magnitude() + im.upper_magnitude()); }
    bound lower_magnitude() const { return std::max(re.lower_magnitude(), im.lower_magnitude()); }

    friend complex_ball operator+(const complex_ball& a, const complex_ball& b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend complex_ball operator-(const complex_ball& a, const complex_ball& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend complex_ball operator*(const complex_ball& a, const complex_ball& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend complex_ball operator*(const complex_ball& a, const ball& b) { return {a.re * b, a.im * b}; }
    /// Throws undecided where b contains 0.
    friend complex_ball operator/(const complex_ball& a, const complex_ball& b) {
        const ball n = b.re * b.re + b.im * b.im;
        return {(a.re * b.re + a.im * b.im) / n, (a.im * b.re - a.re * b.im) / n};
    }
};

}  // namespace stagecraft::tableaux
