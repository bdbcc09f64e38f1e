// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/exercises/html.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/exercises/html_escaped.hpp"

namespace stagecraft::theory {

namespace detail {

inline std::string tagged(const std::string& tag, const std::string& inside) {
    return "<" + tag + ">" + inside + "</" + tag + ">";
}

/// A sign of the size of letters, a parenthesis too.
inline std::string sign(const std::string& what) { return "<mo stretchy=\"false\">" + what + "</mo>"; }

/// What a command without arguments draws: a sign, or a Greek letter, which HTML has by the same name.
STAGECRAFT_INLINE std::string drawn(std::string_view name) {
    static constexpr std::array<std::string_view, 6> sizes{"left", "right", "bigl", "bigr", "quad", "mathrm"};
    if (std::find(sizes.begin(), sizes.end(), name) != sizes.end()) return {};
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 12> signs{
        {{"le", "le"},
         {"ge", "ge"},
         {"ne", "ne"},
         {"sum", "sum"},
         {"langle", "lang"},
         {"rangle", "rang"},
         {"cdot", "sdot"},
         {"infty", "infin"},
         {"to", "rarr"},
         {"dots", "hellip"},
         {"pm", "plusmn"},
         {"implies", "rArr"}}};
    for (const auto& [command, entity] : signs)
        if (command == name) return sign("&" + std::string(entity) + ";");
    return tagged("mi", name == "det" ? "det" : "&" + std::string(name) + ";");
}

STAGECRAFT_INLINE std::string mathml(std::string_view text);

/// The command whose name begins at position `at`, with its arguments; `at` moves behind it.
STAGECRAFT_INLINE std::string formula_command(std::string_view text, std::size_t& at) {
    std::size_t end = at;
    while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
    const auto name = text.substr(at, end - at);
    if (name.empty()) {  // \, \; \{
        const char next = at < text.size() ? text[at++] : ' ';
        return next == ',' || next == ';' || next == '!' ? ""
                                                         : tagged("mo", html_escaped(std::string(1, next)));
    }
    at = end;
    if (name == "frac" || name == "tfrac") {
        const auto top = mathml(argument(text, at)), bottom = mathml(argument(text, at));
        return tagged("mfrac", top + bottom);
    }
    if (name == "sqrt") return tagged("msqrt", mathml(argument(text, at)));
    if (name == "mathbf")
        return "<mstyle style=\"font-weight: bold\">" + mathml(argument(text, at)) + "</mstyle>";
    if (name == "dot") {
        while (at < text.size() && text[at] == ' ') ++at;
        return tagged("mover", mathml(argument(text, at)) + "<mo>&#775;</mo>");
    }
    return drawn(name);
}

/// The atom at position `at`, which moves behind it: a number, a letter, a group, a command.
STAGECRAFT_INLINE std::string formula_atom(std::string_view text, std::size_t& at) {
    const auto digit = [&](std::size_t i) {
        return i < text.size() && (std::isdigit(static_cast<unsigned char>(text[i])) != 0 || text[i] == '.');
    };
    if (digit(at)) {
        const auto begin = at;
        while (digit(at)) ++at;
        return tagged("mn", std::string(text.substr(begin, at - begin)));
    }
    if (text[at] == '{') return mathml(argument(text, at));
    const char c = text[at++];
    if (c == '\\') return formula_command(text, at);
    if (c == ' ' || c == '~' || c == '}') return {};
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) return tagged("mi", std::string(1, c));
    if (c == '-') return "<mo>&minus;</mo>";
    if (c == '\'') return "<mo>&prime;</mo>";
    return sign(html_escaped(std::string(1, c)));
}

/// A formula without its dollars, as one row of MathML.
STAGECRAFT_INLINE std::string mathml(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const auto atom = formula_atom(text, at);
        std::string below, above;
        while (at < text.size() && (text[at] == '_' || text[at] == '^')) {
            auto& where = text[at++] == '_' ? below : above;
            where = mathml(argument(text, at));
        }
        if (below.empty() && above.empty())
            out += atom;
        else if (above.empty())
            out += tagged("msub", atom + below);
        else if (below.empty())
            out += tagged("msup", atom + above);
        else
            out += tagged("msubsup", atom + below + above);
    }
    return tagged("mrow", out);
}

/// A tableau, with its weights below a line, or a matrix in parentheses.
STAGECRAFT_INLINE std::string array_of(const text_block& block) {
    const bool tableau = block.kind == text_block::form::tableau;
    std::string rows;
    for (std::size_t i = 0; i < block.rows.size(); ++i) {
        std::string row = tableau && i + 1 == block.rows.size() ? "<mtd></mtd>" : "";
        for (const auto& entry : block.rows[i]) row += tagged("mtd", mathml(entry));
        rows += tagged("mtr", row);
    }
    const auto table = tableau ? "<mtable class=\"tableau\">" + rows + "</mtable>"
                               : "<mo>(</mo>" + tagged("mtable", rows) + "<mo>)</mo>";
    return "<math display=\"block\">" + mathml(block.text) + table + "</math>\n";
}

}  // namespace detail

STAGECRAFT_INLINE std::string html(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at <= text.size();) {
        const auto begin = std::min(text.find('$', at), text.size());
        for (const char c : text.substr(at, begin - at))
            out += c == '~' ? "&nbsp;" : html_escaped(std::string(1, c));
        if (begin == text.size()) break;
        const auto end = std::min(text.find('$', begin + 1), text.size());
        out += detail::tagged("math", detail::mathml(text.substr(begin + 1, end - begin - 1)));
        at = end + 1;
    }
    return out;
}

STAGECRAFT_INLINE std::string to_html(const document& d) {
    std::string out;
    for (const auto& block : d)
        out += block.kind == text_block::form::paragraph ? detail::tagged("p", html(block.text)) + "\n"
                                                         : detail::array_of(block);
    return out;
}

}  // namespace stagecraft::theory
