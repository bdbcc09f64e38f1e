// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace stagecraft {

/// x^(-1/q) for q > 0, which every accepted step asks for and the next one waits for.
template <class Scalar>
Scalar inverse_root(const Scalar& x, int q) {
    using std::pow;
    return pow(x, Scalar(-1) / Scalar(q));
}

/// The same but for 2e-4 / q of it where 2^-q < x, in a third of the time of pow; a step size needs a digit or two. With
/// x = 2^e (1 - y), |y| <= 1/3, it is (1 - y)^(-1/q) times exp(-e log(2) / q), eight terms of the series of each, summed in
/// pairs that do not wait for each other. Nothing but 1 is divided, as f may keep the divider busy.
inline double inverse_root(double x, int q) {
    const auto bits = std::bit_cast<std::uint64_t>(x), least = std::bit_cast<std::uint64_t>(2.0 / 3);
    const std::int64_t e = static_cast<std::int64_t>(bits - least) >> 52;
    const double p = 1.0 / q;
    if (e > 0 || e < -q) return std::pow(x, -p);  // NaN and what is not positive among them
    const auto sum = [](double v, double c1, double c2, double c3, double c4, double c5, double c6,
                        double c7) {
        const double v2 = v * v;
        return ((1 + c1 * v) + v2 * (c2 + c3 * v)) + v2 * v2 * ((c4 + c5 * v) + v2 * (c6 + c7 * v));
    };
    const double y = 1 - std::bit_cast<double>(bits - (static_cast<std::uint64_t>(e) << 52));
    const double c2 = p * (1 + p) * (1. / 2), c3 = c2 * (2 + p) * (1. / 3), c4 = c3 * (3 + p) * (1. / 4),
                 c5 = c4 * (4 + p) * (1. / 5), c6 = c5 * (5 + p) * (1. / 6), c7 = c6 * (6 + p) * (1. / 7);
    const double z = static_cast<double>(-e) * (std::numbers::ln2 * p);
    return sum(y, p, c2, c3, c4, c5, c6, c7) *
           sum(z, 1, 1. / 2, 1. / 6, 1. / 24, 1. / 120, 1. / 720, 1. / 5040);
}

}  // namespace stagecraft
