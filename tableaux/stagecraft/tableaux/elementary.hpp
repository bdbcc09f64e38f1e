// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <stagecraft/tableaux/range.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stdexcept>

/// pi, cos and sin of entries, by enclosures.

namespace stagecraft::tableaux {

namespace detail {

/// 160 decimal digits: 40 more than an entry's enclosure keeps, so that a few units of the last place of a
/// function value, and the reduction of arguments up to 1000, do not matter.
using wide_float =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<160>, boost::multiprecision::et_off>;

inline wide_float widened(const rational& x) {
    return wide_float(x.numerator()) / wide_float(x.denominator());
}

/// x and 2^-440 to either side, which is 30 digits beyond its rounding errors.
inline range around(const wide_float& x) {
    const auto units = static_cast<integer>(boost::multiprecision::floor(ldexp(x, 440)));
    return {scaled(rational(integer(units - 1)), -440), scaled(rational(integer(units + 2)), -440)};
}

/// f on an interval, for an f whose derivative is at most 1 in size.
template <class F>
range nonexpansive(const range& x, F f) {
    if (x.lower < -1000 || x.upper > 1000)
        throw std::invalid_argument("the argument of cos or sin lies beyond 1000");
    const rational radius = x.width() / rational(2);
    const range value = around(f(widened(x.middle())));
    return {value.lower - radius, value.upper + radius};
}

}  // namespace detail

inline range pi_range() { return detail::around(boost::math::constants::pi<detail::wide_float>()); }

/// Encloses cos x and sin x. Throws std::invalid_argument for arguments beyond 1000.
inline range cos(const range& x) {
    return detail::nonexpansive(x, [](const auto& m) { return boost::multiprecision::cos(m); });
}
inline range sin(const range& x) {
    return detail::nonexpansive(x, [](const auto& m) { return boost::multiprecision::sin(m); });
}

}  // namespace stagecraft::tableaux
