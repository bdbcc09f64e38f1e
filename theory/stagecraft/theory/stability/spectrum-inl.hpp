// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/stability/spectrum.hpp"

#include <cstddef>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/correct_rounding.hpp"
#include "stagecraft/tableaux/exact_tableau.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE std::string beyond_largest_spectrum() {
    return "eigenvalues and poles are enclosed up to " + std::to_string(largest_spectrum) + " stages";
}

STAGECRAFT_INLINE int count(const spectrum& all) {
    int n = 0;
    for (const auto& v : all) n += v.multiplicity * (v.is_real() ? 1 : 2);
    return n;
}

namespace detail {

STAGECRAFT_INLINE tableaux::ball exact_to_ball(const tableaux::quadratic& x, int bits) {
    return tableaux::to_ball(x, bits);
}

STAGECRAFT_INLINE void sort(spectrum& all) {
    const auto key = [](const spectral_value& v) {
        return std::pair(v.value.im.middle(), v.value.re.middle());
    };
    std::sort(all.begin(), all.end(), [&](const auto& x, const auto& y) { return key(x) < key(y); });
}

STAGECRAFT_INLINE void require_moderate(const std::vector<tableaux::ball>& coefficients) {
    for (const auto& a : coefficients)
        if (const auto size = a.upper_magnitude(); !a.exactly_zero() && !(size < 1e300L && size > 1e-300L))
            throw tableaux::undecided("coefficients of the characteristic polynomial beyond 1e300");
}

}  // namespace detail

STAGECRAFT_INLINE spectrum reciprocals(const spectrum& all) {
    spectrum inverse;
    for (const auto& v : all) {
        if (v.is_real() && v.value.re.exactly_zero()) continue;
        if (v.exact) {
            inverse.push_back(
                detail::exactly(tableaux::quadratic(1) / *v.exact, v.multiplicity, v.value.re.bits()));
        } else if (v.is_real()) {
            inverse.push_back({{tableaux::ball(1) / v.value.re, 0}, {}, v.multiplicity});
        } else {
            inverse.push_back({(tableaux::complex_ball{1, 0} / v.value).conjugate(), {}, v.multiplicity});
            if (v.value.re.exactly_zero()) inverse.back().value.re = 0;
        }
    }
    detail::sort(inverse);
    return inverse;
}

namespace detail {

STAGECRAFT_INLINE spectrum with_zeros(spectrum all, int multiplicity) {
    if (multiplicity > 0) all.push_back(exactly(tableaux::rational(0), multiplicity, checker_bits));
    sort(all);
    return all;
}

STAGECRAFT_INLINE std::string digits_of(const tableaux::ball& x) {
    if (auto text = tableaux::decimal_text(x, spectrum_digits)) return *std::move(text);
    return tableaux::decimal_text(x.middle(), spectrum_digits);
}

STAGECRAFT_INLINE bool is_certain(const tableaux::ball& x) {
    return tableaux::decimal_text(x, spectrum_digits).has_value();
}

STAGECRAFT_INLINE std::string with_radius(const tableaux::ball& x) {
    return digits_of(x) + (is_certain(x) ? "" : " within " + brief(x.radius()));
}

}  // namespace detail

STAGECRAFT_INLINE std::string text(const spectrum& all) {
    std::string out;
    for (const auto& v : all) {
        if (!out.empty()) out += ", ";
        if (v.exact && v.exact->str().size() <= 20)
            out += v.exact->str() + (v.exact->is_rational() ? "" : " = " + detail::with_radius(v.value.re));
        else if (v.is_real())
            out += detail::with_radius(v.value.re);
        else
            out += detail::with_radius(v.value.re) + " +- " + detail::with_radius(v.value.im) + " i";
        if (v.multiplicity > 1) out += " (multiplicity " + std::to_string(v.multiplicity) + ")";
    }
    return all.empty() ? "none" : out;
}

}  // namespace stagecraft::theory
