// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/statements/certainty.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE tableaux::ball to_ball(const tableaux::range& r) {
    using tableaux::ball;
    const tableaux::rational middle = r.middle();
    const tableaux::rational half = r.width() / tableaux::rational(2);
    const auto up = [](const tableaux::rational& x) {
        if (x == 0) return tableaux::bound(0);
        const int k = 62 - tableaux::binary_exponent(x);  // 62 bits and one to be above x
        return std::ldexp(static_cast<tableaux::bound>(static_cast<std::int64_t>(floor(scaled(x, k)))) + 1,
                          -k);
    };
    if (middle == 0) return ball(ball::mantissa(0), 0, up(half), checker_bits);
    const int k = checker_bits - tableaux::binary_exponent(middle);
    const tableaux::integer m = floor(scaled(middle, k));
    const bool whole = scaled(middle, k) == tableaux::rational(m);
    const auto rounding = whole ? tableaux::bound(0) : std::ldexp(tableaux::bound(1), -k);
    const auto radius = half == 0 && whole ? tableaux::bound(0) : tableaux::upward(up(half) + rounding);
    return ball(ball::mantissa(m), -k, radius, checker_bits);
}

STAGECRAFT_INLINE std::string brief(tableaux::bound x) {
    if (std::abs(x) < 1e-4900L) return "0";  // upper bounds of zero are the least positive number
    char text[32];
    std::snprintf(text, sizeof text, "%.3Lg", x);
    return text;
}

STAGECRAFT_INLINE std::string shown(const tableaux::ball& x) {
    return brief(x.middle().to<tableaux::bound>()) + " +- " + brief(x.radius());
}

STAGECRAFT_INLINE verdict open_case(tableaux::bound residual, tableaux::bound bound, tableaux::bound scale,
                                    const std::string& reason) {
    if (!says_nothing(bound, scale)) return verdict::consistent(brief(residual), brief(bound), reason);
    return verdict::inconclusive(brief(residual), brief(bound),
                                 reason + ", too few digits to refute anything of size " + brief(scale));
}

STAGECRAFT_INLINE verdict both(const verdict& x, const verdict& y) {
    if (x.is_refuted()) return x;
    if (y.is_refuted()) return y;
    if (y.is_inconclusive()) return x.is_inconclusive() ? x : y;
    return x.is_proved() ? y : x;
}

STAGECRAFT_INLINE verdict negation(const verdict& x) {
    if (x.is_proved()) return verdict::refuted(x.reason());
    if (x.is_refuted()) return verdict::proved(x.reason());
    return x;
}

}  // namespace stagecraft::theory
