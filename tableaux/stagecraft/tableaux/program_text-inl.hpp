// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_text.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/json_document.hpp"
#include "stagecraft/tableaux/read.hpp"
#include "stagecraft/tableaux/reading.hpp"
#include "stagecraft/tableaux/tableau_file.hpp"

namespace stagecraft::tableaux {

namespace program_text {

inline bool opens(char ch) { return ch == '[' || ch == '{'; }
inline bool closes(char ch) { return ch == ']' || ch == '}'; }
inline bool is_blank(char ch) { return std::isspace(static_cast<unsigned char>(ch)) != 0; }
inline bool is_word(char ch) { return std::isalnum(static_cast<unsigned char>(ch)) != 0 || ch == '_'; }

/// Without comments: from # % or ! to the end of the line, as in Python, Julia, Matlab and Fortran; from // where
/// it stands between no two numbers, and between /* and */, as in C. Fortran's (/ and /) become brackets, and marks
/// of a line that goes on (& and ...) blanks.
STAGECRAFT_INLINE std::string without_comments(std::string_view text) {
    std::string out;
    const auto at = [&](std::size_t i) { return i < text.size() ? text[i] : ' '; };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view two = text.substr(i, 2);
        const bool fraction = i > 0 && (is_word(text[i - 1]) || text[i - 1] == ')') &&
                              (is_word(at(i + 2)) || at(i + 2) == '(' || at(i + 2) == '-');
        if (at(i) == '#' || at(i) == '%' || (at(i) == '!' && at(i + 1) != '=') ||
            (two == "//" && !fraction)) {
            i = std::min(text.find('\n', i), text.size());
            out += '\n';
        } else if (two == "/*") {
            i = std::min(text.find("*/", i + 2), text.size()) + 1;
        } else if (two == "//") {
            out += "//";
            ++i;
        } else if (two == "(/" || two == "/)") {
            out += two == "(/" ? '[' : ']';
            ++i;
        } else if (text.substr(i, 3) == "...") {
            i = std::min(text.find('\n', i), text.size());  // what follows on the line is a comment
        } else if (text[i] == '&') {
            const auto next = text.find_first_not_of(" \t\r\n&", i);
            i = std::min(next, text.size()) - 1;
            out += ' ';
        } else {
            out += text[i];
        }
    }
    return out;
}

/// Where the bracketed text that begins at `begin` ends, one past it; the end of the text where it is not closed.
STAGECRAFT_INLINE std::size_t end_of_brackets(std::string_view text, std::size_t begin) {
    int depth = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        depth += opens(text[i]) ? 1 : closes(text[i]) ? -1 : 0;
        if (depth == 0) return i + 1;
    }
    return text.size();
}

/// An array as it stands in a program.
struct array_text {
    std::string inside;       ///< brackets included; empty where there is none
    bool by_columns = false;  ///< of Fortran's reshape
};

/// What follows "NAME =", "NAME[..][..] =", "NAME(..) =" or "NAME{": a call such as np.array( or reshape( may stand before the
/// brackets, and a type such as Rational{Int}.
STAGECRAFT_INLINE array_text array_named(std::string_view text, std::string_view name) {
    for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
        if (at > 0 && is_word(text[at - 1])) continue;
        std::size_t i = at + name.size();
        if (i < text.size() && (is_word(text[i]) || text[i] == '.')) continue;
        const std::size_t sign = std::min(text.find_first_of("=:{", i), text.size());
        const auto between = text.substr(i, sign - i);  // blanks, or sizes as in b[4] or b(4)
        if (between.find_first_not_of(" \t[]()0123456789sS,") != std::string_view::npos) continue;
        if (sign == text.size()) break;
        std::size_t begin = text[sign] == '{' ? sign : sign + 1;
        int parentheses = 0;
        for (; begin < text.size() && text[begin] != ';' && (text[begin] != '\n' || parentheses > 0);
             ++begin) {
            parentheses += text[begin] == '(' ? 1 : text[begin] == ')' ? -1 : 0;
            if (!opens(text[begin])) continue;
            const std::size_t end = end_of_brackets(text, begin);
            if (text[begin] == '{' && end < text.size() && (text[end] == '[' || text[end] == '(')) {
                begin = end - 1;  // the parameters of a type
                continue;
            }
            const auto before = text.substr(sign, begin - sign);
            const auto after = text.substr(end, std::min(text.find('\n', end), text.size()) - end);
            const bool reshaped = before.find("reshape") != std::string_view::npos;
            const bool turned = before.find("transpose") != std::string_view::npos ||
                                after.find("order") != std::string_view::npos;
            return {std::string(text.substr(begin, end - begin)), reshaped && !turned};
        }
    }
    return {};
}

/// "1//2" as in Julia, "Rational(1, 2)" and "Fraction(1, 2)" as in Python, "0.5f" and "0.5L" as in C, "0.5d0" and
/// "0.5_dp" as in Fortran, "**".
STAGECRAFT_INLINE std::string plain_number(std::string text) {
    const auto replace_all = [&](std::string_view from, std::string_view to) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    };
    replace_all("//", "/");
    replace_all("**", "^");
    for (const std::string_view type : {"sympy.", "np.", "math.", "std::"}) replace_all(type, "");
    for (const std::string_view type : {"Rational", "Fraction"}) {
        for (std::size_t at = text.find(type); at != std::string::npos; at = text.find(type)) {
            text.erase(at, type.size());
            const auto comma = text.find(',', at);
            if (comma != std::string::npos) text.replace(comma, 1, ")/(");
        }
    }
    std::string out;
    const auto after_number = [&](std::size_t i) {
        return i > 0 && (std::isdigit(static_cast<unsigned char>(text[i - 1])) || text[i - 1] == '.');
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '_' && after_number(i)) {  // the kind of a number
            while (i + 1 < text.size() && is_word(text[i + 1])) ++i;
            continue;
        }
        if ((text[i] == 'd' || text[i] == 'D') && after_number(i)) {
            out += 'e';
            continue;
        }
        const bool suffix = std::string_view("fFlL").find(text[i]) != std::string_view::npos &&
                            after_number(i) && (i + 1 == text.size() || !is_word(text[i + 1]));
        if (!suffix) out += text[i];
    }
    return out;
}

/// The numbers of a row: apart by commas outside parentheses or, where there are none, by blanks.
STAGECRAFT_INLINE std::vector<std::string> numbers_of(std::string_view row) {
    const auto split = [&](auto separates) {
        std::vector<std::string> parts(1);
        int depth = 0;
        for (const char ch : row) {
            depth += ch == '(' ? 1 : ch == ')' ? -1 : 0;
            if (depth == 0 && separates(ch))
                parts.emplace_back();
            else
                parts.back() += ch;
        }
        for (auto& p : parts) {
            p.erase(0, std::min(p.find_first_not_of(" \t\r\n"), p.size()));
            p.erase(p.find_last_not_of(" \t\r\n") + 1);
        }
        std::erase(parts, "");
        return parts;
    };
    auto parts = split([](char ch) { return ch == ','; });
    if (parts.size() == 1 && row.find(',') == std::string_view::npos) {
        std::vector<std::string> joined;  // "1/4 - 1/6" is one number, "1/4 -1/6" are two
        const auto is_operator = [](const std::string& p) { return p.find_first_not_of("+-*/") == p.npos; };
        bool goes_on = false;
        for (auto& p : split(is_blank)) {
            const bool op = is_operator(p);
            if ((op || goes_on) && !joined.empty())
                joined.back() += p;
            else
                joined.push_back(std::move(p));
            goes_on = op;
        }
        parts = std::move(joined);
    }
    for (auto& p : parts) p = plain_number(std::move(p));
    return parts;
}

/// The rows inside the outer brackets: innermost brackets; or apart by semicolons or lines (Julia, Matlab); or one row.
STAGECRAFT_INLINE std::vector<std::vector<std::string>> rows_of(const std::string& array) {
    const std::string_view inside = std::string_view(array).substr(1, array.size() - 2);
    std::vector<std::vector<std::string>> rows;
    std::size_t begin = 0;
    if (std::any_of(inside.begin(), inside.end(), opens)) {
        bool innermost = false;
        for (std::size_t i = 0; i < inside.size(); ++i) {
            if (opens(inside[i])) begin = i + 1;
            if (closes(inside[i]) && innermost) rows.push_back(numbers_of(inside.substr(begin, i - begin)));
            innermost = opens(inside[i]) || (innermost && !closes(inside[i]));
        }
        return rows;
    }
    while (begin <= inside.size()) {
        auto end = std::min(inside.find_first_of(";\n", begin), inside.size());
        const auto last = inside.substr(0, end).find_last_not_of(" \t\r");
        while (end < inside.size() && inside[end] == '\n' && last != inside.npos && inside[last] == ',')
            end = std::min(inside.find_first_of(";\n", end + 1), inside.size());  // the row goes on
        if (auto row = numbers_of(inside.substr(begin, end - begin)); !row.empty())
            rows.push_back(std::move(row));
        begin = end + 1;
    }
    return rows;
}

/// A, where all s^2 numbers stand in one row: by rows, or by columns as Fortran's reshape takes them.
STAGECRAFT_INLINE std::vector<std::vector<std::string>> square(const std::vector<std::string>& all,
                                                               std::size_t s, bool by_columns) {
    std::vector<std::vector<std::string>> rows(s, std::vector<std::string>(s));
    for (std::size_t i = 0; i < s; ++i)
        for (std::size_t j = 0; j < s; ++j) rows[i][j] = all[by_columns ? j * s + i : i * s + j];
    return rows;
}

}  // namespace program_text

STAGECRAFT_INLINE tableau_file read_program_text(std::string_view source, const reading& how) {
    const std::string text = program_text::without_comments(source);
    nlohmann::json j = nlohmann::json::object();
    const auto vector_named = [&](const char* key, std::initializer_list<const char*> names) {
        for (const char* name : names)
            if (const auto array = program_text::array_named(text, name).inside; !array.empty()) {
                std::vector<std::string> all;
                for (auto& row : program_text::rows_of(array)) all.insert(all.end(), row.begin(), row.end());
                j[key] = all;
                return;
            }
    };
    vector_named("b", {"b", "B"});
    vector_named("c", {"c", "C"});
    vector_named("b_embedded", {"b_embedded", "b_hat", "bhat", "b_tilde", "btilde", "b2", "bh"});
    for (const char* name : {"A", "a"}) {
        const auto array = program_text::array_named(text, name);
        if (array.inside.empty()) continue;
        auto rows = program_text::rows_of(array.inside);
        const std::size_t s = j.contains("b") ? j["b"].size() : 0;
        std::vector<std::string> all;
        for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
        if (s > 1 && all.size() == s * s && rows.size() != s)
            rows = program_text::square(all, s, array.by_columns);
        if (j.contains("b") && rows.size() + 1 == j["b"].size())
            rows.insert(rows.begin(), {});  // no first row
        for (auto& row : rows)
            if (row.size() < rows.size()) row.resize(rows.size(), "0");
        j["A"] = rows;
        break;
    }
    for (const char* key : {"order", "embedded_order", "stage_order"}) {
        const auto at = text.find(std::string("\n") + key);
        const auto sign = at == std::string::npos ? at : text.find('=', at);
        if (sign != std::string::npos) j["claims"][key] = std::atoi(text.c_str() + sign + 1);
    }
    return read_tableau(j.dump(), how);
}

}  // namespace stagecraft::tableaux
