// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/entry.hpp"

#include <algorithm>
#include <boost/spirit/home/x3.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/elementary.hpp"
#include "stagecraft/tableaux/real_root.hpp"

namespace stagecraft::tableaux {

namespace expression_grammar {

struct program_tag {};
namespace x3 = boost::spirit::x3;

template <char Code>
inline constexpr auto emit = [](auto& context) {
    x3::get<program_tag>(context).get().push_back({Code, {}});
};
inline constexpr auto emit_literal = [](auto& context) {
    const auto& matched = x3::_attr(context);
    x3::get<program_tag>(context).get().push_back({'#', std::string(matched.begin(), matched.end())});
};

// Every alternative is decided by its first word, so no action ever runs twice.
inline const x3::rule<struct sum_id> sum = "a number";
inline const x3::rule<struct signed_id> signed_power = "a number";
inline const auto exponent = x3::char_("eE") >> -x3::char_("+-") >> +x3::digit;
inline const auto literal =
    x3::raw[x3::lexeme[((+x3::digit >> -('.' >> *x3::digit)) | ('.' >> +x3::digit)) >> -exponent]];
inline const auto variable = x3::lexeme[x3::lit('x') >> !x3::alnum];
inline const auto primary = literal[emit_literal] | variable[emit<'x'>] | ('(' > sum > ')') |
                            x3::lexeme["pi" >> !x3::alnum][emit<'p'>] |
                            (x3::lexeme["sqrt" >> !x3::alnum] > '(' > sum > x3::lit(')')[emit<'r'>]) |
                            (x3::lexeme["cbrt" >> !x3::alnum] > '(' > sum > x3::lit(')')[emit<'k'>]) |
                            (x3::lexeme["cos" >> !x3::alnum] > '(' > sum > x3::lit(')')[emit<'c'>]) |
                            (x3::lexeme["sin" >> !x3::alnum] > '(' > sum > x3::lit(')')[emit<'s'>]);
inline const auto signed_power_def =
    ('-' > signed_power)[emit<'n'>] | ('+' > signed_power) | (primary >> -('^' > signed_power)[emit<'^'>]);
inline const auto product = signed_power >>
                            *(('*' > signed_power)[emit<'*'>] | ('/' > signed_power)[emit<'/'>]);
inline const auto sum_def = product >> *(('+' > product)[emit<'+'>] | ('-' > product)[emit<'-'>]);
BOOST_SPIRIT_DEFINE(sum, signed_power)

/// Longest text of an entry and deepest nesting accepted: far beyond any published tableau, and small
/// enough for the parser's recursion.
inline constexpr std::size_t longest_text = 4096;
inline constexpr int deepest_nesting = 100;

/// Throws where parentheses, powers or signs in a row nest deeper than deepest_nesting.
STAGECRAFT_INLINE void require_shallow(std::string_view text) {
    int open = 0, deepest = 0, signs = 0;
    char previous = '(';
    for (const char ch : text) {
        if (ch == ' ' || ch == '\t') continue;
        if (ch == '(') deepest = std::max(deepest, ++open);
        if (ch == ')') --open;
        const bool after_operator = std::string_view("(+-*/^").find(previous) != std::string_view::npos;
        if (ch == '^' || ((ch == '-' || ch == '+') && after_operator)) ++signs;
        previous = ch;
    }
    if (deepest > deepest_nesting || signs > 2 * deepest_nesting)
        throw std::invalid_argument("nested too deeply");
}

STAGECRAFT_INLINE std::string describe_failure(std::string_view text, std::size_t at) {
    const auto skip = text.find_first_not_of(" \t", at);
    if (skip == std::string_view::npos) return text.empty() ? "is empty" : "ends too early";
    const auto letter = [](char ch) {
        return (ch >= 'a' && ch <= 'z') || (ch >= 'A' && ch <= 'Z') || ch == '_';
    };
    std::size_t end = skip;
    while (end < text.size() && letter(text[end])) ++end;
    const auto before = text.substr(0, skip).find_last_not_of(" \t");
    const bool after_number = before != std::string_view::npos &&
                              (text[before] == ')' || (text[before] >= '0' && text[before] <= '9'));
    const char ch = text[skip];
    if (end > skip) {
        const std::string word(text.substr(skip, end - skip));
        const bool known = word == "sqrt" || word == "cbrt" || word == "cos" || word == "sin" || word == "pi";
        return known && after_number ? "a * is missing before '" + word + "'"
                                     : "unknown symbol '" + word + "'";
    }
    if (ch == '(' && after_number) return "a * is missing before '('";
    const std::string shown = ch > ' ' && ch < 127 ? std::string(1, ch) : "?";
    return "unexpected '" + shown + "' at character " + std::to_string(skip + 1);
}

STAGECRAFT_INLINE std::vector<instruction> compile(std::string_view text) {
    if (text.size() > longest_text) throw std::invalid_argument("longer than 4096 characters");
    require_shallow(text);
    std::vector<instruction> program;
    auto at = text.begin();
    const auto grammar = x3::with<program_tag>(std::ref(program))[sum];
    bool matched = false;
    try {
        matched = x3::phrase_parse(at, text.end(), grammar, x3::blank);
    } catch (const x3::expectation_failure<std::string_view::iterator>& failure) {
        at = failure.where();
        matched = false;
    }
    if (!matched || at != text.end())
        throw std::invalid_argument(describe_failure(text, static_cast<std::size_t>(at - text.begin())));
    return program;
}

/// Values longer than this are no longer carried exactly; those beyond the second bound are refused.
inline constexpr int exact_bits = 4096;

STAGECRAFT_INLINE entry from_exact(quadratic x) {
    if (bit_size(x) > largest_bits) throw std::invalid_argument("too large a number");
    entry e;
    e.enclosure = to_range(x);
    if (bit_size(x) <= exact_bits) e.exact = std::move(x);
    return e;
}

STAGECRAFT_INLINE rational power_of_ten(int k) {
    const integer p = pow(integer(10), static_cast<unsigned>(std::abs(k)));
    return k < 0 ? rational(integer(1), p) : rational(p);
}

/// A literal as integer times power of ten, and how it is written.
struct decimal_literal {
    integer number = 0;
    int scale = 0;
    int digits = 0;        ///< significant ones
    bool decimal = false;  ///< with a point or an exponent
    int places() const { return std::max(0, -scale); }
    /// "3.0" or "3.", as programs write whole numbers.
    bool whole() const { return scale == 0 || (scale == -1 && number % 10 == 0); }
};

STAGECRAFT_INLINE decimal_literal parse_literal(const std::string& text) {
    decimal_literal x;
    std::string digits;
    bool after_point = false;
    std::size_t i = 0;
    for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
        if (text[i] == '.') {
            x.decimal = after_point = true;
        } else {
            digits += text[i];
            x.scale -= after_point ? 1 : 0;
        }
    }
    if (i < text.size()) {
        x.decimal = true;
        const std::string shift = text.substr(i + 1);
        if (shift.size() > 5)
            throw std::invalid_argument("non-finite: exponent " +
                                        (shift.size() > 40 ? shift.substr(0, 40) + "..." : shift));
        x.scale += std::stoi(shift);
    }
    // Boost reads a leading zero as octal.
    const auto first = digits.find_first_not_of('0');
    x.number = integer(first == std::string::npos ? "0" : digits.substr(first));
    x.digits = first == std::string::npos ? 0 : static_cast<int>(digits.size() - first);
    if (x.decimal && std::abs(x.scale) > 5000)
        throw std::invalid_argument("non-finite: exponent " + std::to_string(x.scale));
    return x;
}

STAGECRAFT_INLINE entry from_literal(const std::string& text, const exact_decimals& exact,
                                     bool beside_others) {
    const decimal_literal x = parse_literal(text);
    if (!x.decimal) return from_exact(rational(x.number));
    if (beside_others && x.whole()) return from_exact(rational(x.number) * power_of_ten(x.scale));
    const rational unit = power_of_ten(x.scale);
    const rational value = rational(x.number) * unit;
    entry e;
    if (std::abs(x.scale) <= 300 && exact.covers(x.digits, x.places())) {
        e = from_exact(value);
    } else {
        e.rounded = true;
        e.enclosure = {value - unit / rational(2), value + unit / rational(2)};
    }
    return e;
}

STAGECRAFT_INLINE entry from_parts(const entry& x, const entry& y, std::optional<quadratic> exact,
                                   range enclosure) {
    if (exact) return from_exact(std::move(*exact));
    entry e;
    e.rounded = x.rounded || y.rounded;
    e.enclosure = std::move(enclosure);
    if (bit_size(e.enclosure.lower) > largest_bits || bit_size(e.enclosure.upper) > largest_bits)
        throw std::invalid_argument("too large a number");
    return e;
}

STAGECRAFT_INLINE entry square_root(const entry& x) {
    if (x.enclosure.upper < 0) throw std::invalid_argument("square root of a negative number");
    if (x.exact) {
        if (auto root = exact_sqrt(*x.exact)) return from_exact(std::move(*root));
    }
    return from_parts(x, x, std::nullopt, sqrt(x.enclosure));
}

/// The n-th root of a number that is not negative, exact where it is rational.
STAGECRAFT_INLINE entry nth_root(const entry& x, int n) {
    if (n == 2) return square_root(x);
    if (x.enclosure.upper < 0) throw std::invalid_argument("root of a negative number");
    if (x.exact && x.exact->is_rational()) {
        const auto whole = [n](const integer& m) -> std::optional<integer> {
            const integer r = integer_root(m, n);
            return pow(r, static_cast<unsigned>(n)) == m ? std::optional(r) : std::nullopt;
        };
        const rational q = x.exact->rational_part();
        const auto above = whole(q.numerator()), below = whole(q.denominator());
        if (above && below) return from_exact(rational(*above, *below));
    }
    return from_parts(x, x, std::nullopt, root(x.enclosure, n));
}

STAGECRAFT_INLINE entry cube_root(const entry& x) {
    if (x.enclosure.lower >= 0) return nth_root(x, 3);
    if (x.enclosure.upper > 0) throw std::invalid_argument("cube root of a number of unknown sign");
    entry y = x;
    y.enclosure = -x.enclosure;
    if (x.exact) y.exact = -*x.exact;
    y = nth_root(y, 3);
    return from_parts(x, x, y.exact ? std::optional(-*y.exact) : std::nullopt, -y.enclosure);
}

/// Roots beyond this one occur in no published method.
inline constexpr int highest_root = 12;

STAGECRAFT_INLINE entry power(entry x, const entry& n) {
    if (!n.exact || !n.exact->is_rational() || n.exact->rational_part().denominator() > highest_root)
        throw std::invalid_argument(
            "an exponent must be an integer or a fraction with a denominator up to 12");
    if (const integer q = n.exact->rational_part().denominator(); q > 1) x = nth_root(x, static_cast<int>(q));
    const integer times = n.exact->rational_part().numerator();
    const entry one = from_exact(1);
    const int size = std::max({bit_size(x.enclosure.lower), bit_size(x.enclosure.upper), 2});
    const bool trivial = x.exact && (*x.exact == 0 || abs(*x.exact) == quadratic(1));
    if (abs(times) > largest_bits || (!trivial && abs(times) * size > 2 * largest_bits)) {
        if (!trivial) throw std::invalid_argument("too large a power");
        if (times % 2 == 0 && *x.exact != 0) return one;
        if (times > 0 || *x.exact != 0) return x;
    }
    entry result = one;
    for (integer k = abs(times); k > 0; k >>= 1) {
        if (bit_test(k, 0)) result = combine(result, x, [](const auto& a, const auto& b) { return a * b; });
        if (k > 1) x = combine(x, x, [](const auto& a, const auto& b) { return a * b; });
    }
    if (times >= 0) return result;
    return combine(one, result, [](const auto& a, const auto& b) { return a / b; });
}

/// Whether the expression combines several numbers.
STAGECRAFT_INLINE bool several_numbers(const std::vector<instruction>& program) {
    return std::count_if(program.begin(), program.end(), [](const auto& i) { return i.code == '#'; }) > 1;
}

STAGECRAFT_INLINE entry run(const std::vector<instruction>& program, const exact_decimals& exact) {
    std::vector<entry> stack;
    const bool several = several_numbers(program);
    for (const auto& [code, number] : program) {
        if (code == '#') {
            stack.push_back(from_literal(number, exact, several));
            continue;
        }
        if (code == 'x') throw std::invalid_argument("unknown symbol 'x'");
        if (code == 'p') {
            entry pi;
            pi.enclosure = pi_range();
            stack.push_back(std::move(pi));
            continue;
        }
        entry y = std::move(stack.back());
        stack.pop_back();
        if (code == 'n') {
            stack.push_back(
                from_parts(y, y, y.exact ? std::optional(-*y.exact) : std::nullopt, -y.enclosure));
            continue;
        }
        if (code == 'r') {
            stack.push_back(square_root(y));
            continue;
        }
        if (code == 'k') {
            stack.push_back(cube_root(y));
            continue;
        }
        if (code == 'c' || code == 's') {
            const bool zero = y.exact && *y.exact == 0;  // the only rational argument with a rational value
            stack.push_back(
                zero ? from_exact(code == 'c' ? 1 : 0)
                     : from_parts(y, y, std::nullopt, code == 'c' ? cos(y.enclosure) : sin(y.enclosure)));
            continue;
        }
        entry x = std::move(stack.back());
        stack.pop_back();
        const auto operation = [code = code](const auto& a, const auto& b) {
            return code == '+' ? a + b : code == '-' ? a - b : code == '*' ? a * b : a / b;
        };
        stack.push_back(code == '^' ? power(std::move(x), y) : combine(x, y, operation));
    }
    return std::move(stack.back());
}

}  // namespace expression_grammar

STAGECRAFT_INLINE std::string with_ascii_minus(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool typographic_minus = text.substr(i, 3) == "\xE2\x88\x92";
        plain += typographic_minus ? '-' : text[i];
        i += typographic_minus ? 2 : 0;
    }
    return plain;
}

STAGECRAFT_INLINE entry read_entry(std::string_view text, const exact_decimals& exact) {
    entry e;
    const auto program = expression_grammar::compile(with_ascii_minus(text));
    try {
        e = expression_grammar::run(program, exact);
    } catch (const std::domain_error&) {
        throw std::invalid_argument("division by zero");
    }
    const rational huge = scaled(1, 1000);
    if (e.enclosure.lower < -huge || e.enclosure.upper > huge)
        throw std::invalid_argument("non-finite: the value exceeds 2^1000");
    e.text = std::string(text);
    for (const auto& [code, literal] : program) {
        if (code != '#') continue;
        const auto x = expression_grammar::parse_literal(literal);
        if (!x.decimal || (x.whole() && expression_grammar::several_numbers(program))) continue;
        e.digits = std::max({e.digits, x.digits, 1});  // 0.0 has one
        e.places = std::max(e.places, x.places());
    }
    return e;
}

STAGECRAFT_INLINE entry entry_from_double(double x, std::string text) {
    if (!std::isfinite(x)) throw std::invalid_argument("non-finite");
    const rational value = exactly(x);
    const double next = std::nextafter(std::abs(x), std::numeric_limits<double>::infinity());
    const int ulp_exponent = std::ilogb(next - std::abs(x));
    entry e;
    e.rounded = true;
    e.enclosure = {value - scaled(1, ulp_exponent - 1), value + scaled(1, ulp_exponent - 1)};
    if (!text.empty()) {
        const entry as_decimal = read_entry(text);
        e.digits = as_decimal.digits;
        e.places = as_decimal.places;
        e.text = std::move(text);
    }
    return e;
}

}  // namespace stagecraft::tableaux
