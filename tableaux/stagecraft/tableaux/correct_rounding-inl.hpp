// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/correct_rounding.hpp"

#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/rough_ball.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE ball_ends ends(const ball& x) {
    integer m(x.digits());
    if (x.exact()) return {m, m, x.exponent()};
    if (x.radius() > std::numeric_limits<bound>::max()) throw undecided("round: nothing is known");
    const auto [r, e] = ball::bound_parts(x.radius());
    integer radius(r);
    const long common = std::min(e, x.exponent());
    m <<= static_cast<unsigned>(x.exponent() - common);
    radius <<= static_cast<unsigned>(e - common);
    return {integer(m - radius), integer(m + radius), common};
}

STAGECRAFT_INLINE decimal nearest_decimal(const integer& n, const integer& d, int digits) {
    const double log10 = (static_cast<double>(msb(n)) - static_cast<double>(msb(d))) * 0.30102999566398120;
    int scale = digits - 1 - static_cast<int>(std::floor(log10));  // digits before the point of x 10^scale
    for (;; --scale) {
        const integer ten = pow(integer(10), static_cast<unsigned>(std::abs(scale)));
        const integer down = scale >= 0 ? d : integer(d * ten);
        integer q, rest;
        divide_qr(scale >= 0 ? integer(n * ten) : n, down, q, rest);
        const int size = static_cast<int>(q.str().size());
        if (q == 0 || size < digits) {
            scale += 2;
            continue;
        }
        if (size > digits) continue;
        rest *= 2;
        if (rest > down || (rest == down && bit_test(q, 0))) ++q;  // ties to even
        std::string text = q.str();
        if (static_cast<int>(text.size()) == digits) return {std::move(text), -scale};
        return {text.substr(0, static_cast<std::size_t>(digits)), 1 - scale};  // 99...9.7 became 100...0
    }
}

STAGECRAFT_INLINE std::string to_text(const decimal& x, bool negative) {
    std::string s = x.digits;
    const int lead = static_cast<int>(s.size()) - 1 + x.exponent;  // exponent of the first digit
    if (lead < -7 || x.exponent > 0) {
        if (s.size() > 1) s.insert(1, ".");
        s += "e" + std::to_string(lead);
    } else if (lead < 0) {
        s = "0." + std::string(static_cast<std::size_t>(-lead - 1), '0') + s;
    } else if (x.exponent < 0) {
        s.insert(static_cast<std::size_t>(lead) + 1, ".");
    }
    return negative ? "-" + s : s;
}

STAGECRAFT_INLINE std::string decimal_text(const rational& q, int digits) {
    if (q == 0) return "0";
    return to_text(nearest_decimal(abs(q).numerator(), q.denominator(), digits), q < 0);
}

STAGECRAFT_INLINE std::optional<std::string> decimal_text(const ball& x, int digits) {
    if (x.exactly_zero()) return "0";
    if (!certainly_nonzero(x)) return {};
    const ball_ends e = ends(x);
    const auto rounded = [&](integer n) {
        if (n < 0) n = -n;
        const integer power = integer(1) << static_cast<unsigned>(std::abs(e.exponent));
        return e.exponent < 0 ? nearest_decimal(n, power, digits)
                              : nearest_decimal(integer(n * power), integer(1), digits);
    };
    const decimal low = rounded(e.lower);
    if (!(low == rounded(e.upper))) return {};
    return to_text(low, e.lower < 0);
}

}  // namespace stagecraft::tableaux
