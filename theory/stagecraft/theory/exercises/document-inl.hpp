// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/document.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE std::string latex(const rational& q) {
    if (q.denominator() == 1) return q.str();
    return std::string(q < 0 ? "-" : "") + "\\frac{" + rational(abs(q).numerator()).str() + "}{" +
           rational(q.denominator()).str() + "}";
}

STAGECRAFT_INLINE std::string latex(const polynomial<rational>& p, const std::string& variable) {
    std::string out;
    for (int k = 0; k <= p.degree(); ++k) {
        const rational a = p[k];
        if (a == 0) continue;
        const std::string sign = a < 0 ? (out.empty() ? "-" : " - ") : (out.empty() ? "" : " + ");
        const std::string power = k == 0 ? "" : k == 1 ? variable : variable + "^{" + std::to_string(k) + "}";
        const std::string size = k > 0 && abs(a) == 1 ? "" : latex(abs(a));
        out += sign + size + (!size.empty() && !power.empty() ? " " : "") + power;
    }
    return out.empty() ? "0" : out;
}

namespace detail {

/// What stands in braces after position `at`, which moves behind it; else the next character.
STAGECRAFT_INLINE std::string_view argument(std::string_view text, std::size_t& at) {
    if (at >= text.size() || text[at] != '{') return text.substr(at++, 1);
    std::size_t depth = 0, end = at;
    do {
        depth += text[end] == '{' ? 1U : 0U;
        depth -= text[end] == '}' ? 1U : 0U;
        ++end;
    } while (depth > 0 && end < text.size());
    const auto inside = text.substr(at + 1, end - at - 2);
    at = end;
    return inside;
}

STAGECRAFT_INLINE bool is_atom(const std::string& text) {
    return std::all_of(text.begin(), text.end(),
                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '\''; });
}

inline std::string in_parentheses(const std::string& text) { return is_atom(text) ? text : "(" + text + ")"; }

/// Commands without arguments that stand for a text; others stand for their name (\lambda: lambda).
STAGECRAFT_INLINE std::string plain_command(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 20> known{
        {{"le", "<="}, {"ge", ">="},     {"ne", "!="},    {"cdot", "*"},     {"to", "->"},
         {"pm", "+-"}, {"infty", "inf"}, {"langle", "<"}, {"rangle", ">"},   {"quad", "   "},
         {"left", ""}, {"right", ""},    {"dots", "..."}, {"implies", "=>"}, {"mathrm", ""},
         {"dot", ""},  {"mathbf", ""},   {"bigl", ""},    {"bigr", ""},      {"mid", "|"}}};
    for (const auto& [command, text] : known)
        if (command == name) return std::string(text);
    return std::string(name);
}

}  // namespace detail

STAGECRAFT_INLINE std::string plain(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at++];
        if (c == '$' || c == '{' || c == '}') continue;
        if (c == '~') {
            out += ' ';
        } else if (c == '^' || c == '_') {
            out += c + detail::in_parentheses(plain(detail::argument(text, at)));
        } else if (c == '\\') {
            std::size_t end = at;
            while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
            const auto name = text.substr(at, end - at);
            if (name.empty()) {  // \, \; \% \{ ...
                const char next = at < text.size() ? text[at++] : ' ';
                out += next == ',' || next == ';' || next == '!' ? (next == '!' ? "" : " ")
                                                                 : std::string(1, next);
                continue;
            }
            at = end;
            if (name == "frac" || name == "tfrac") {
                const auto top = plain(detail::argument(text, at)),
                           bottom = plain(detail::argument(text, at));
                out += detail::in_parentheses(top) + "/" + detail::in_parentheses(bottom);
            } else if (name == "sqrt") {
                out += "sqrt(" + plain(detail::argument(text, at)) + ")";
            } else {
                const auto word = detail::plain_command(name);
                if (word.empty() && at < text.size() && text[at] == ' ') ++at;
                out += word;
            }
        } else {
            out += c;
        }
    }
    return out;
}

namespace detail {

/// The rows of plain entries in columns, right-aligned.
STAGECRAFT_INLINE std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t bar) {
    std::size_t width = 0, columns = 0;
    for (const auto& row : rows) {
        columns = std::max(columns, row.size());
        for (const auto& x : row) width = std::max(width, x.size());
    }
    std::string out;
    for (const auto& row : rows) {
        out += "    ";
        for (std::size_t j = 0; j < row.size(); ++j)
            out += std::string(width - row[j].size() + (j == 0 ? 0 : 2), ' ') + row[j] +
                   (j + 1 == bar ? " |" : "");
        out += "\n";
    }
    return out;
}

STAGECRAFT_INLINE std::string joined(const std::vector<std::string>& row) {
    std::string out;
    for (const auto& x : row) out += (out.empty() ? "" : " & ") + x;
    return out;
}

/// Breaks lines after at most 100 characters.
STAGECRAFT_INLINE std::string wrapped(const std::string& text) {
    constexpr std::size_t most = 100;
    std::string out, line;
    for (std::size_t at = 0; at <= text.size();) {
        const auto end = std::min(text.find(' ', at), text.size());
        const auto word = text.substr(at, end - at);
        if (!line.empty() && line.size() + 1 + word.size() > most) {
            out += line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
        at = end + 1;
    }
    return out + line + "\n";
}

}  // namespace detail

STAGECRAFT_INLINE std::string to_text(const document& d) {
    std::string out;
    for (const auto& block : d) {
        if (block.kind == text_block::form::paragraph) {
            out += detail::wrapped(plain(block.text));
            continue;
        }
        auto rows = block.rows;
        for (auto& row : rows)
            for (auto& x : row) x = plain(x);
        const bool tableau = block.kind == text_block::form::tableau;
        if (tableau) rows.back().insert(rows.back().begin(), std::string());
        if (auto before = plain(block.text); !before.empty()) {
            while (before.back() == ' ') before.pop_back();
            out += before + "\n";
        }
        out += detail::aligned(rows, tableau ? 1 : 0);
    }
    return out;
}

STAGECRAFT_INLINE std::string to_latex(const document& d) {
    std::string out;
    for (const auto& block : d) {
        if (block.kind == text_block::form::paragraph) {
            out += block.text + "\n\n";
            continue;
        }
        const bool tableau = block.kind == text_block::form::tableau;
        const std::string columns(block.rows.front().size() - (tableau ? 1 : 0), 'c');
        out += "\\[" + block.text + (tableau ? "\\begin{array}{c|" + columns + "}\n" : "\\begin{pmatrix}\n");
        for (std::size_t i = 0; i < block.rows.size(); ++i) {
            const bool weights = tableau && i + 1 == block.rows.size();
            out += std::string(weights ? "\\hline\n & " : "") + detail::joined(block.rows[i]) + " \\\\\n";
        }
        out += std::string(tableau ? "\\end{array}" : "\\end{pmatrix}") + "\\]\n";
    }
    return out;
}

}  // namespace stagecraft::theory
