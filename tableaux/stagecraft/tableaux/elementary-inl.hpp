// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/elementary.hpp"

#include <stdexcept>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/rational.hpp"

namespace stagecraft::tableaux {

namespace detail {

/// Values are computed as integers in units of 2^-560 and enclosed to 2^-440, 12 digits more than an entry's
/// enclosure keeps.
inline constexpr int working_bits = 560, enclosed_bits = 440;

STAGECRAFT_INLINE range around(const integer& x) {
    const integer units = x >> (working_bits - enclosed_bits);
    return {scaled(rational(integer(units - 1)), -enclosed_bits),
            scaled(rational(integer(units + 2)), -enclosed_bits)};
}

/// arctan(1/q) by its series, wrong by less than 2^9 units: one for each of its terms.
STAGECRAFT_INLINE integer arctan_of_inverse(int q) {
    integer power = (integer(1) << working_bits) / q, sum = 0;
    for (int k = 1; power != 0; k += 2) {
        sum += k % 4 == 1 ? integer(power / k) : integer(-power / k);
        power /= q * q;
    }
    return sum;
}

/// cos x and sin x for 0 <= x <= 1000, wrong by less than 2^33 units: the series at x/2^24, wrong by less than 2^8,
/// then 24 times the square of cos + i sin, each of which doubles the error.
STAGECRAFT_INLINE std::pair<integer, integer> cos_and_sin(const rational& x) {
    constexpr int doublings = 24;
    const integer angle = (x.numerator() << (working_bits - doublings)) / x.denominator();
    integer cosine = 0, sine = 0, term = integer(1) << working_bits;
    for (int n = 0; term != 0; ++n) {
        integer& sum = n % 2 == 0 ? cosine : sine;
        sum += n % 4 < 2 ? term : integer(-term);
        term = ((term * angle) >> working_bits) / (n + 1);
    }
    for (int k = 0; k < doublings; ++k) {
        const integer square = (cosine * cosine - sine * sine) >> working_bits;
        sine = (cosine * sine) >> (working_bits - 1);
        cosine = square;
    }
    return {cosine, sine};
}

/// f on an interval, for an f whose derivative is at most 1 in size; f_of takes its middle.
template <class F>
range nonexpansive(const range& x, F f_of) {
    if (x.lower < -1000 || x.upper > 1000)
        throw std::invalid_argument("the argument of cos or sin lies beyond 1000");
    const rational radius = x.width() / rational(2);
    const range value = around(f_of(x.middle()));
    return {value.lower - radius, value.upper + radius};
}

}  // namespace detail

STAGECRAFT_INLINE range pi_range() {
    return detail::around(16 * detail::arctan_of_inverse(5) - 4 * detail::arctan_of_inverse(239));
}

STAGECRAFT_INLINE range cos(const range& x) {
    return detail::nonexpansive(x, [](const rational& m) { return detail::cos_and_sin(abs(m)).first; });
}

STAGECRAFT_INLINE range sin(const range& x) {
    return detail::nonexpansive(x, [](const rational& m) {
        const integer sine = detail::cos_and_sin(abs(m)).second;
        return m < 0 ? integer(-sine) : sine;
    });
}

}  // namespace stagecraft::tableaux
