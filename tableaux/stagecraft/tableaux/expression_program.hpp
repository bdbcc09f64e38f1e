// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stagecraft::tableaux::expression_grammar {

/// One instruction of the stack machine that an expression compiles to: a literal or one of + - * / ^,
/// 'n' (negate), 'r' (square root), 'c' (cos), 's' (sin), 'p' (pi), 'x' (the variable of a polynomial).
struct instruction {
    char code;
    std::string literal;
};

/// Longest text of an entry and deepest nesting accepted: far beyond any published tableau, and small
/// enough for the parser's recursion.
inline constexpr std::size_t longest_text = 4096;
inline constexpr int deepest_nesting = 100;

/// Throws where parentheses, powers or signs in a row nest deeper than deepest_nesting.
inline void require_shallow(std::string_view text) {
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

inline bool is_digit(char ch) { return ch >= '0' && ch <= '9'; }
inline bool is_letter(char ch) { return (ch >= 'a' && ch <= 'z') || (ch >= 'A' && ch <= 'Z'); }

inline std::string describe_failure(std::string_view text, std::size_t at) {
    const auto skip = text.find_first_not_of(" \t", at);
    if (skip == std::string_view::npos) return text.empty() ? "is empty" : "ends too early";
    std::size_t end = skip;
    while (end < text.size() && (is_letter(text[end]) || text[end] == '_')) ++end;
    if (end > skip) return "unknown symbol '" + std::string(text.substr(skip, end - skip)) + "'";
    const char ch = text[skip];
    const std::string shown = ch > ' ' && ch < 127 ? std::string(1, ch) : "?";
    return "unexpected '" + shown + "' at character " + std::to_string(skip + 1);
}

/// Recursive descent; each member takes what it is named after from the text and appends its instructions:
///     sum = product {(+ | -) product}       product = power {(* | /) power}
///     power = (- | +) power | primary [^ power]
///     primary = literal | x | pi | [sqrt | cos | sin] ( sum )
struct compiler {
    std::string_view text;
    std::size_t at = 0;
    std::vector<instruction> program{};

    void sum() {
        product();
        for (;;) {
            if (take('+'))
                product(), emit('+');
            else if (take('-'))
                product(), emit('-');
            else
                return;
        }
    }

  private:
    void product() {
        power();
        for (;;) {
            if (take('*'))
                power(), emit('*');
            else if (take('/'))
                power(), emit('/');
            else
                return;
        }
    }
    void power() {
        if (take('-')) return power(), emit('n');
        if (take('+')) return power();
        primary();
        if (take('^')) power(), emit('^');
    }
    void primary() {
        if (take_literal()) return;
        if (take_word("x")) return emit('x');
        if (take_word("pi")) return emit('p');
        const char function = take_word("sqrt") ? 'r' : take_word("cos") ? 'c' : take_word("sin") ? 's' : '(';
        expect('(');
        sum();
        expect(')');
        if (function != '(') emit(function);
    }
    /// Digits with at most one point among or beside them, then an exponent if it has digits.
    bool take_literal() {
        skip_blanks();
        std::size_t end = digits_end(at);
        const bool point = look(end) == '.' && (end > at || is_digit(look(end + 1)));
        if (end == at && !point) return false;
        if (point) end = digits_end(end + 1);
        if (look(end) == 'e' || look(end) == 'E') {
            const std::size_t first = end + (look(end + 1) == '+' || look(end + 1) == '-' ? 2 : 1);
            if (is_digit(look(first))) end = digits_end(first);
        }
        program.push_back({'#', std::string(text.substr(at, end - at))});
        at = end;
        return true;
    }
    /// Neither a letter nor a digit follows the word.
    bool take_word(std::string_view word) {
        skip_blanks();
        const char next = look(at + word.size());
        if (text.substr(at, word.size()) != word || is_letter(next) || is_digit(next)) return false;
        at += word.size();
        return true;
    }
    bool take(char ch) {
        skip_blanks();
        const bool there = look(at) == ch;
        at += there ? 1 : 0;
        return there;
    }
    void expect(char ch) {
        if (!take(ch)) throw std::invalid_argument(describe_failure(text, at));
    }
    void emit(char code) { program.push_back({code, {}}); }
    void skip_blanks() {
        while (look(at) == ' ' || look(at) == '\t') ++at;
    }
    char look(std::size_t i) const { return i < text.size() ? text[i] : '\0'; }
    std::size_t digits_end(std::size_t i) const {
        while (is_digit(look(i))) ++i;
        return i;
    }
};

/// The program of an expression. Throws std::invalid_argument: what was found where something else must stand,
/// longer than longest_text, nested too deeply.
inline std::vector<instruction> compile(std::string_view text) {
    if (text.size() > longest_text) throw std::invalid_argument("longer than 4096 characters");
    require_shallow(text);
    compiler c{text};
    c.sum();
    if (text.find_first_not_of(" \t", c.at) != std::string_view::npos)
        throw std::invalid_argument(describe_failure(text, c.at));
    return std::move(c.program);
}

}  // namespace stagecraft::tableaux::expression_grammar
