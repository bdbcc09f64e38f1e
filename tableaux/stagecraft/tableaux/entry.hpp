// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stagecraft/tableaux/range.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace stagecraft::tableaux {

/// One number of a tableau file. Three kinds: exact in a field of at most two surds (`exact` is set); exact but outside
/// (three or nested surds, or very long fractions), known by an enclosure of about 120 digits; and rounded
/// data, uncertain by half a unit of the last digit written.
struct entry {
    std::string text;                ///< as written
    std::optional<quadratic> exact;  ///< the value, where two surds suffice
    range enclosure{0, 0};           ///< contains the value; a point for a rational one
    bool rounded = false;            ///< some part is a decimal that is not exact
    int digits = 0;                  ///< significant digits of the longest decimal in it; 0: there is none
    int places = 0;                  ///< digits after the point, the most of a decimal in it

    /// What half a unit of the last digit allows: 0 for exact data.
    rational uncertainty() const { return rounded ? enclosure.width() / rational(2) : rational(0); }
};

/// Decimals with at most so many significant digits and so many digits after the point are exact numbers.
struct exact_decimals {
    int digits = 0;
    int places = 0;

    static constexpr exact_decimals all() { return {1 << 20, 300}; }
    bool covers(int n, int after_point) const { return n <= digits && after_point <= places; }
    /// Whether reading e again may change it.
    bool covers_some(const entry& e) const { return digits > 0 && e.digits > 0; }
};

namespace expression_grammar {

/// One instruction of the stack machine that an expression compiles to: a literal or one of + - * / ^,
/// 'n' (negate), 'r' (square root), 'c' (cos), 's' (sin), 'p' (pi), 'x' (the variable of a polynomial).
struct instruction {
    char code;
    std::string literal;
};

std::vector<instruction> compile(std::string_view text);

inline constexpr int largest_bits = 20000;

entry from_exact(quadratic x);

/// 10^k for small k of either sign.
rational power_of_ten(int k);

/// An integer literal is exact; with a point or an exponent it is known to half a unit of its last digit,
/// unless it is one of the `exact` ones, or a whole number beside others, as in "1.0/3.0".
entry from_literal(const std::string& text, const exact_decimals& exact = {}, bool beside_others = false);

entry from_parts(const entry& x, const entry& y, std::optional<quadratic> exact, range enclosure);

template <class Operation>
entry combine(const entry& x, const entry& y, Operation operation) {
    if (x.exact && y.exact) try {
            return from_exact(operation(*x.exact, *y.exact));
        } catch (const mixed_surds&) {  // a third surd: enclose
        }
    return from_parts(x, y, std::nullopt, operation(x.enclosure, y.enclosure));
}

/// x^n by repeated squaring, n a small integer; n/2 is taken as a root.
entry power(entry x, const entry& n);

entry run(const std::vector<instruction>& program, const exact_decimals& exact);

}  // namespace expression_grammar

/// The text with printed minus signs (U+2212) replaced by hyphens.
std::string with_ascii_minus(std::string_view text);

/// Reads one number: an exact expression in integers, + - * / ^, parentheses, sqrt(), cos(), sin() and pi, or
/// with decimals in it (a decimal point or an exponent marks rounded data, but "1.0/3.0" is 1/3). The minus sign may be U+2212, as printed in
/// papers. Throws std::invalid_argument saying what is wrong: unknown symbol, division by zero, square root
/// of a negative number, non-finite, a power too large (2^(10^9) is refused, not computed), nesting too deep.
entry read_entry(std::string_view text, const exact_decimals& exact = {});

/// The entry for a double, written as `text`: rounded data, uncertain by half a unit in its last place.
/// Throws std::invalid_argument for an infinity or a NaN.
entry entry_from_double(double x, std::string text = {});

}  // namespace stagecraft::tableaux

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/tableaux/entry-inl.hpp"
#endif
