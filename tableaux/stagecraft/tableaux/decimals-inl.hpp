// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/decimals.hpp"

#include <stdexcept>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/correct_rounding.hpp"
#include "stagecraft/tableaux/exact_tableau.hpp"
#include "stagecraft/tableaux/rounded.hpp"

namespace stagecraft::tableaux {

STAGECRAFT_INLINE decimal_tableau decimals(const nodal_polynomial& w, construction rule, int digits) {
    if (digits < 1) throw std::invalid_argument("digits: at least 1 needed, got " + std::to_string(digits));
    const int bits = working_bits(bits_for_digits(digits), w);
    const auto decided = [&](const ball& x) {
        auto text = decimal_text(x, digits);
        if (!text) throw undecided("round: a number is undecided to " + std::to_string(digits) + " digits");
        return *std::move(text);
    };
    if (const auto exact = exact_tableau(w, rule))
        return rounding::texts(*exact, [&](const quadratic& x) {
            if (x.is_rational()) return decimal_text(x.rational_part(), digits);
            return widening(bits, [&](int b) { return decided(to_ball(x, b)); });
        });
    return widening(bits, [&](int b) { return rounding::texts(enclose(w, rule, b), decided); });
}

STAGECRAFT_INLINE decimal_tableau decimals(family f, int s, int digits) {
    return decimals(nodal_polynomial(f, s), construction_of(f), digits);
}

}  // namespace stagecraft::tableaux
