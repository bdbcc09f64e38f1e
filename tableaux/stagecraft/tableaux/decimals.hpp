// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/correct_rounding.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/rounded.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace stagecraft::tableaux {

/// A tableau as text: c, b and the rows of A, every number correctly rounded to `digits` significant decimal
/// digits (ties to even; zero is "0").
struct decimal_tableau {
    std::vector<std::string> c;
    std::vector<std::vector<std::string>> A;
    std::vector<std::string> b;
};

namespace rounding {

/// Takes a tableau over any scalar to text, number by number.
template <class Table, class Text>
decimal_tableau texts(const Table& t, Text text) {
    decimal_tableau out;
    for (Eigen::Index i = 0; i < t.c.size(); ++i) {
        out.c.push_back(text(t.c(i)));
        out.b.push_back(text(t.b(i)));
        out.A.emplace_back();
        for (Eigen::Index j = 0; j < t.c.size(); ++j) out.A.back().push_back(text(t.A(i, j)));
    }
    return out;
}

}  // namespace rounding

/// The decimal tableau of a method. If the nodes lie in a quadratic field the numbers are exact before they
/// are rounded, so that 1/4 to one digit is recognised as a tie. Otherwise they come from enclosures, whose
/// precision is increased until all ends agree. Cost: that of `enclose` and two conversions per entry. Throws
/// std::invalid_argument for digits < 1 and undecided where a rounding stays undecided.
inline decimal_tableau decimals(const nodal_polynomial& w, construction rule, int digits) {
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

inline decimal_tableau decimals(family f, int s, int digits) {
    return decimals(nodal_polynomial(f, s), construction_of(f), digits);
}

}  // namespace stagecraft::tableaux
