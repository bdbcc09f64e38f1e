// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux::program_text {

STAGECRAFT_INLINE bool is_sign(const token& t, std::string_view text) {
    return t.is == token::kind::sign && t.text == text;
}
STAGECRAFT_INLINE bool is_open(const token& t) {
    return is_sign(t, "(") || is_sign(t, "[") || is_sign(t, "{");
}
STAGECRAFT_INLINE bool is_close(const token& t) {
    return is_sign(t, ")") || is_sign(t, "]") || is_sign(t, "}");
}

/// Where a comment may begin: some of the marks mean something else in another language.
enum class comment_place { anywhere, line_start, before_blank, no_modulo, no_negation, no_fraction };

struct comment_mark {
    std::string_view open, close;  ///< close: a line's end where it is empty
    comment_place place = comment_place::anywhere;
};

/// Longer marks first. Python, Julia, R: #; Matlab, LaTeX: %; Fortran: !; C, Rust: //; Lua: --; Mathematica: (*.
inline constexpr std::array<comment_mark, 9> comment_marks{{{"#=", "=#"},
                                                            {"#", ""},
                                                            {"%{", "%}", comment_place::line_start},
                                                            {"%", "", comment_place::no_modulo},
                                                            {"/*", "*/"},
                                                            {"//", "", comment_place::no_fraction},
                                                            {"!", "", comment_place::no_negation},
                                                            {"--", "", comment_place::before_blank},
                                                            {"(*", "*)", comment_place::before_blank}}};

/// Signs of several characters, longer ones first.
inline constexpr std::array<std::string_view, 25> long_signs{
    "...", "==", "!=", "~=", "<=", ">=", ":=", "=>", "->", "::", "+=", "-=", "*=",
    "/=",  "**", "//", "<<", ">>", "<-", "&&", "||", ".*", "./", ".^", ".'"};

/// Cuts a program into tokens.
class lexer {
  public:
    explicit lexer(std::string_view source) : source_(source) {
        if (source_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // the mark of UTF-8
    }

    std::vector<token> run() && {
        while (at_ < source_.size()) {
            const char ch = source_[at_];
            if (ch == '\n') {
                end_line();
            } else if (is_blank(ch)) {
                blank_ = true;
                ++at_;
            } else if (!skip_continuation() && !skip_disabled() && !take_definition() && !skip_comment() &&
                       !take_quotes()) {
                if (is_digit(ch) || (ch == '.' && is_digit(peek(1))))
                    take_number();
                else if (is_word(ch))
                    take_word();
                else
                    take_sign();
            }
        }
        push(token::kind::line_end, "");
        pair_brackets();
        return std::move(tokens_);
    }

  private:
    static bool is_blank(char ch) { return std::isspace(static_cast<unsigned char>(ch)) != 0; }
    static bool is_digit(char ch) { return std::isdigit(static_cast<unsigned char>(ch)) != 0; }
    static bool is_word(char ch) {
        return std::isalnum(static_cast<unsigned char>(ch)) != 0 || ch == '_' || (ch & 0x80) != 0;
    }
    char peek(std::size_t k) const { return at_ + k < source_.size() ? source_[at_ + k] : '\n'; }
    char before() const { return at_ > 0 ? source_[at_ - 1] : '\n'; }
    bool here(std::string_view text) const { return source_.substr(at_, text.size()) == text; }
    bool line_starts() const { return tokens_.empty() || tokens_.back().is == token::kind::line_end; }
    const token* last() const { return line_starts() ? nullptr : &tokens_.back(); }

    void push(token::kind is, std::string text) {
        tokens_.push_back({is, std::move(text), line_, at_ - line_begin_, blank_ || line_starts()});
        blank_ = false;
    }

    void count_line() {
        ++line_;
        line_begin_ = at_ + 1;
        blank_ = true;
    }

    void end_line() {
        if (!line_starts()) push(token::kind::line_end, "");
        count_line();
        ++at_;
    }

    /// Skips to `end`, and counts the lines on the way.
    void skip_to(std::size_t end) {
        for (; at_ < std::min(end, source_.size()); ++at_)
            if (source_[at_] == '\n') count_line();
        blank_ = true;
    }

    /// Fortran's & and a backslash before the end of a line, Matlab's "..." with what follows on the line.
    bool skip_continuation() {
        const bool rest = here("...") && !is_word(peek(3));
        if (!rest && !here("&") && !here("\\")) return false;
        const auto next = source_.find_first_not_of(" \t\r", at_ + 1);
        const bool comment = here("&") && next != nowhere && source_[next] == '!';
        if (here("&") && line_starts()) {  // the line that goes on
            ++at_;
            return true;
        }
        if (!rest && !comment && next != nowhere && source_[next] != '\n') return false;
        skip_to(std::min(source_.find('\n', at_), source_.size()));
        skip_to(at_ + 1);
        const auto begin = source_.find_first_not_of(" \t", at_);
        if (begin != nowhere && source_[begin] == '&' && !rest) at_ = begin + 1;  // where the line goes on
        return true;
    }

    /// C's "#if 0" up to its "#else" or "#endif"; what stands within another #if there goes with it.
    bool skip_disabled() {
        if (!line_starts() || !here("#if 0")) return false;
        int depth = 0;
        do {
            skip_to(std::min(source_.find('\n', at_), source_.size()) + 1);
            while (at_ < source_.size() && is_blank(source_[at_]) && source_[at_] != '\n') ++at_;
            if (here("#if")) ++depth;
            if (depth == 0 && (here("#el") || here("#endif"))) break;
            if (here("#endif")) --depth;
        } while (at_ < source_.size());
        return true;
    }

    /// "#define ORDER 4", but no function.
    bool take_definition() {
        if (!line_starts() || !here("#define")) return false;
        const auto begin = source_.find_first_not_of(" \t", at_ + 7);
        auto end = begin;
        while (end < source_.size() && is_word(source_[end])) ++end;
        if (begin == nowhere || end == begin || end >= source_.size() || source_[end] == '(') return false;
        at_ = begin;
        push(token::kind::word, std::string(source_.substr(begin, end - begin)));
        push(token::kind::sign, "=");
        at_ = end;
        return true;
    }

    bool skip_comment() {
        for (const auto& mark : comment_marks) {
            if (!here(mark.open) || !is_comment(mark)) continue;
            const auto end = mark.close.empty() ? source_.find('\n', at_)
                                                : source_.find(mark.close, at_ + mark.open.size());
            skip_to(end == nowhere ? source_.size() : end + mark.close.size());
            return true;
        }
        return false;
    }

    bool is_comment(const comment_mark& mark) const {
        const auto size = mark.open.size();
        const char next = peek(size);
        if (mark.open == "#=" && next == '=') return false;  // a line of ===== behind Python's #
        switch (mark.place) {
            case comment_place::anywhere:
                return true;
            case comment_place::line_start:
                return line_starts();
            case comment_place::before_blank:
                return is_blank(next) && (blank_ || line_starts());
            case comment_place::no_modulo:
                return !is_modulo();
            case comment_place::no_negation:
                return !is_negation(next);
            case comment_place::no_fraction:
                return !is_fraction(next);
        }
        return true;
    }

    /// "i % 2) {", "n % 2 == 0": the rest of the line reads on as a program.
    bool is_modulo() const {
        const auto* left = last();
        if (!left || left->is == token::kind::sign) return left && is_sign(*left, "%");
        const auto rest = source_.substr(at_ + 1, source_.find('\n', at_) - at_ - 1);
        const auto begin = rest.find_first_not_of(" \t");
        return begin != rest.npos && is_word(rest[begin]) && rest.find_first_of(");{]=") != rest.npos;
    }

    /// "!x" as in C, "!=", and names as Julia's f! and Rust's vec![.
    bool is_negation(char next) const {
        if (next == '=' || next == '[' || next == '(' || (is_word(before()) && !is_blank(next))) return true;
        const auto* left = last();
        return is_word(next) && left &&
               (is_sign(*left, "(") || is_sign(*left, "&&") || is_sign(*left, "||") || is_sign(*left, "="));
    }

    /// 1//2 as in Julia.
    bool is_fraction(char next) const {
        const auto* left = last();
        if (!left || (left->is == token::kind::sign && !is_sign(*left, ")")) || left->is == token::kind::text)
            return false;
        if (!is_blank(before())) return is_word(next) || next == '(' || next == '-';
        const auto begin = source_.find_first_not_of(" \t\r", at_ + 2);
        if (begin == nowhere || source_[begin] == '\n') return begin != nowhere;
        auto end = begin;
        while (end < source_.size() && is_word(source_[end])) ++end;
        const bool call = end > begin && end < source_.size() && source_[end] == '(';
        return (left->is == token::kind::number && is_digit(source_[begin])) || (is_sign(*left, ")") && call);
    }

    /// Three quotes are a docstring where a statement begins, else a text.
    bool take_quotes() {
        for (const std::string_view three : {"\"\"\"", "'''"}) {
            if (!here(three)) continue;
            const auto end = source_.find(three, at_ + 3);
            const auto inside = source_.substr(at_ + 3, end == nowhere ? nowhere : end - at_ - 3);
            if (!line_starts()) push(token::kind::text, std::string(inside));
            skip_to(end == nowhere ? source_.size() : end + 3);
            return true;
        }
        const char quote = source_[at_];
        if (quote != '"' && quote != '\'') return false;
        // Matlab's transposition and Rust's lifetimes are no quotes.
        const std::string_view transposed_before(")]}.'");
        if (quote == '\'' && at_ != raw_ &&
            (is_word(before()) || transposed_before.find(before()) != nowhere || before() == '&' ||
             before() == '<'))
            return false;
        auto end = at_ + 1;
        while (end < source_.size() && source_[end] != quote && source_[end] != '\n')
            end += source_[end] == '\\' ? 2 : 1;
        if (end >= source_.size() || source_[end] != quote) return false;
        push(token::kind::text, std::string(source_.substr(at_ + 1, end - at_ - 1)));
        at_ = end + 1;
        return true;
    }

    /// 1_000, 0.5f, 0.5L, 1.0f64, 0.5d0, 0.5_dp.
    void take_number() {
        std::string number;
        auto i = at_;
        const auto digits = [&] {
            while (i < source_.size() &&
                   (is_digit(source_[i]) ||
                    (source_[i] == '_' && i + 1 < source_.size() && is_digit(source_[i + 1])))) {
                if (source_[i] != '_') number += source_[i];
                ++i;
            }
        };
        const auto at = [&](std::size_t k) { return k < source_.size() ? source_[k] : ' '; };
        digits();
        // In "1..." and "1.e" the point belongs to what follows; "1.*x" means the same both ways.
        if (at(i) == '.' && at(i + 1) != '.' && at(i + 1) != '\'') {
            number += source_[i++];
            digits();
        }
        const auto sign = at(i + 1) == '+' || at(i + 1) == '-' ? std::size_t{1} : 0;
        if (std::string_view("eEdDqQ").find(at(i)) != nowhere && is_digit(at(i + 1 + sign))) {
            number += 'e';
            if (sign) number += source_[i + 1];
            i += 1 + sign;
            digits();
        }
        auto end = i;
        while (end < source_.size() && is_word(source_[end])) ++end;
        const auto suffix = source_.substr(i, end - i);
        static constexpr std::array<std::string_view, 9> known{"f",   "F",  "l",  "L", "f64",
                                                               "f32", "f0", "LF", "BF"};
        const bool dropped =
            suffix.starts_with('_') || std::find(known.begin(), known.end(), suffix) != known.end();
        push(token::kind::number, std::move(number));
        at_ = dropped ? end : i;
    }

    void take_word() {
        if (here("\xE2\x88\x9A")) {  // Julia's root
            push(token::kind::sign, "\xE2\x88\x9A");
            at_ += 3;
            return;
        }
        const auto minus = [&](std::size_t k) { return source_.substr(k, 3) == "\xE2\x88\x92"; };
        if (minus(at_)) {  // the typographic one
            push(token::kind::sign, "-");
            at_ += 3;
            return;
        }
        auto end = at_;
        while (end < source_.size() && is_word(source_[end]) && !minus(end)) ++end;
        const auto quote = source_.substr(end, 1) == "\"" || source_.substr(end, 3) == "'''" ||
                           source_.substr(at_, 3) == "r'\\";  // "r'" alone is Matlab's transposition
        if (quote && end == at_ + 1 && std::string_view("uUrRbBfF").find(source_[at_]) != nowhere) {
            raw_ = end;  // Python's r"..."
            ++at_;
            return;
        }
        push(token::kind::word, std::string(source_.substr(at_, end - at_)));
        at_ = end;
    }

    void take_sign() {
        if ((here("(/") && peek(2) != '/' && peek(2) != '*') || here("/)")) {
            push(token::kind::sign, here("(/") ? "[" : "]");
            at_ += 2;
            return;
        }
        const auto* sign =
            std::find_if(long_signs.begin(), long_signs.end(), [&](auto s) { return here(s); });
        const auto text = sign == long_signs.end() ? source_.substr(at_, 1) : *sign;
        push(token::kind::sign, std::string(text));
        at_ += text.size();
    }

    /// A bracket that closes one further out leaves those within without partners.
    void pair_brackets() {
        std::vector<std::size_t> open;
        std::array<std::size_t, 3> count{};
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (is_open(tokens_[i])) {
                open.push_back(i);
                ++count[kind_of(tokens_[i])];
            }
            if (!is_close(tokens_[i]) || count[kind_of(tokens_[i])] == 0) continue;
            for (bool found = false; !found; open.pop_back()) {
                found = kind_of(tokens_[open.back()]) == kind_of(tokens_[i]);
                --count[kind_of(tokens_[open.back()])];
                if (!found) continue;
                tokens_[i].partner = open.back();
                tokens_[open.back()].partner = i;
            }
        }
    }

    static std::size_t kind_of(const token& bracket) {
        return std::string_view("([{)]}").find(bracket.text) % 3;
    }

    std::string_view source_;
    std::vector<token> tokens_;
    std::size_t at_ = 0, line_ = 1, line_begin_ = 0, raw_ = nowhere;
    bool blank_ = true;
};

STAGECRAFT_INLINE std::vector<token> tokens_of(std::string_view source) { return lexer(source).run(); }

}  // namespace stagecraft::tableaux::program_text
