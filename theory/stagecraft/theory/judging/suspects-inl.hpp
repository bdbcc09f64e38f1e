// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/suspects.hpp"

#include <cstdlib>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/entry.hpp"
#include "stagecraft/tableaux/exact_tableau.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE tableaux::rational simplest_in(const tableaux::range& r) {
    if (r.contains(0)) return 0;
    return r.upper < 0 ? -tableaux::simplest_between(-r.upper, -r.lower)
                       : tableaux::simplest_between(r.lower, r.upper);
}

namespace detail {

/// x rounded to `digits` decimals.
STAGECRAFT_INLINE std::string decimal(const tableaux::rational& x, int digits) {
    using tableaux::integer;
    integer n = floor(abs(x) * tableaux::rational(pow(integer(10), static_cast<unsigned>(digits))) +
                      tableaux::rational(1, 2));
    std::string text = n.str();
    if (static_cast<int>(text.size()) <= digits)
        text.insert(0, static_cast<std::size_t>(digits) + 1 - text.size(), '0');
    if (digits > 0) text.insert(text.size() - static_cast<std::size_t>(digits), ".");
    return (x < 0 && n != 0 ? "-" : "") + text;
}

/// x rounded to so many decimals, as a number.
STAGECRAFT_INLINE tableaux::rational decimal_value(const tableaux::rational& x, int digits) {
    const tableaux::rational unit = tableaux::expression_grammar::power_of_ten(-digits);
    return tableaux::rational(floor(x / unit + tableaux::rational(1, 2))) * unit;
}

/// Digits after the point that a repair shows at most: those of the enclosures.
inline constexpr int most_digits = 110;

/// "p/q" with another numerator or another denominator that lies in r; empty where the text is no quotient or there is none.
STAGECRAFT_INLINE std::string quotient_in(const tableaux::range& r, const std::string& text) {
    const auto slash = text.find('/');
    if (slash == text.npos || text.find_first_not_of("+-0123456789./ ") != text.npos || r.contains(0))
        return {};
    const auto part = [&](std::size_t from, std::size_t to) {
        const auto e = tableaux::read_entry(text.substr(from, to - from), tableaux::exact_decimals::all());
        return e.exact->rational_part();
    };
    const auto p = part(0, slash), q = part(slash + 1, text.size());
    const auto nearest = [](const tableaux::rational& v) {
        return tableaux::rational(floor(v + tableaux::rational(1, 2)));
    };
    const auto top = nearest(r.middle() * q);
    if (r.contains(top / q)) return top.str() + "/" + q.str();
    const auto bottom = nearest(p / r.middle());
    if (bottom > 0 && r.contains(p / bottom)) return p.str() + "/" + bottom.str();
    return {};
}

STAGECRAFT_INLINE std::string suggestion(const tableaux::ball& x, const tableaux::entry& old) {
    const tableaux::range r = to_range(x);
    if (auto quotient = quotient_in(r, old.text); old.rounded && !quotient.empty()) return quotient;
    int digits = 0;
    if (!old.rounded) {
        const auto simple = simplest_in(r);
        const auto d = tableaux::rational(simple.denominator());
        if (r.width() * d * d * tableaux::rational(1000) < 1) {
            if (old.digits == 0 || !tableaux::detail::terminates(simple)) return simple.str();
            while (decimal_value(simple, digits) != simple) ++digits;
            return decimal(simple, std::max(digits, 1));
        }
    }
    // The digits that the entry had, and no more than the conditions determine.
    const auto unit = std::max(old.uncertainty() + old.uncertainty(), r.width());
    for (tableaux::rational u = unit; u < 1 && digits < most_digits; u *= tableaux::rational(10)) ++digits;
    return decimal(r.middle(), digits);
}

STAGECRAFT_INLINE int misprint_distance(const std::string& x, const std::string& y) {
    const std::size_t n = std::min<std::size_t>(x.size(), 200), m = std::min<std::size_t>(y.size(), 200);
    std::vector<std::vector<int>> d(n + 1, std::vector<int>(m + 1));
    for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t j = 0; j <= m; ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = static_cast<int>(i + j);
                continue;
            }
            d[i][j] = std::min(
                {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (x[i - 1] == y[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[n][m];
}

/// Changes of so many units of the last digit are corrections of rounding, not of misprints.
inline constexpr int units_of_rounding = 4;

/// What rounding leaves uncertain of the sum that the entry belongs to, its row of A with c or the weights: the most
/// that it leaves of one of them.
STAGECRAFT_INLINE tableaux::rational sum_uncertainty(const tableaux::tableau_file& file, const place& p) {
    tableaux::rational most(0);
    const auto take = [&](const tableaux::entry& e) { most = std::max(most, e.uncertainty()); };
    if (p.part == part::b || p.part == part::b_embedded) {
        for (const auto& e : p.part == part::b ? file.b : file.b_embedded) take(e);
    } else {
        for (const auto& e : file.A[static_cast<std::size_t>(p.row)]) take(e);
        if (!file.c.empty()) take(file.c[static_cast<std::size_t>(p.row)]);
    }
    return most;
}

STAGECRAFT_INLINE bool only_rounding(const tableaux::tableau_file& file, const place& p,
                                     const tableaux::range& value, bool rounded_fractions) {
    const auto& old = entry_at(file, p);
    const auto change = abs(value.middle() - old.enclosure.middle());
    if (change <= tableaux::rational(2 * units_of_rounding) * sum_uncertainty(file, p)) return true;
    return !old.rounded && rounded_fractions && change <= tableaux::expression_grammar::power_of_ten(-12);
}

STAGECRAFT_INLINE std::string without_notation(const std::string& text) {
    if (text.find_first_not_of("+-.0123456789eE") != std::string::npos) return text;
    const auto e = std::min(text.find_first_of("eE"), text.size());
    std::string digits;
    int exponent = e < text.size() ? std::atoi(text.c_str() + e + 1) : 0;
    bool after_point = false;
    for (const char ch : text.substr(0, e)) {
        if (ch == '.') after_point = true;
        if (ch < '0' || ch > '9') continue;
        exponent -= after_point ? 1 : 0;
        if (!digits.empty() || ch != '0') digits += ch;
    }
    exponent += static_cast<int>(digits.size());
    while (!digits.empty() && digits.back() == '0') digits.pop_back();
    return (text.front() == '-' ? "-" : "") + digits + "e" + std::to_string(exponent);
}

STAGECRAFT_INLINE void rank(std::vector<suspect>& suspects) {
    std::stable_sort(suspects.begin(), suspects.end(), [](const suspect& x, const suspect& y) {
        const auto key = [](const suspect& s) {
            return std::pair(s.written == "0" || s.suggest == "0",
                             misprint_distance(without_notation(s.written), without_notation(s.suggest)));
        };
        return key(x) < key(y);
    });
}

}  // namespace detail

}  // namespace stagecraft::theory
