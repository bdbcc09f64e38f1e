// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/array_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/program_calls.hpp"
#include "stagecraft/tableaux/token_cursor.hpp"

namespace stagecraft::tableaux::program_text {

STAGECRAFT_INLINE std::string_view last_part(std::string_view name) {
    const auto at = name.find_last_of(".:>");
    return at == name.npos ? name : name.substr(at + 1);
}

/// Reads a value by recursive descent.
class value_parser : public token_cursor {
  public:
    value_parser(const std::vector<token>& tokens, std::size_t begin, std::size_t end, const lookup& known)
        : token_cursor(tokens, begin, end), known_(known) {}

    value run() {
        value v = sum();
        skip_lines();
        if (at_ < end_) fail("'" + tokens_[at_].text + "' beside it");
        return v;
    }

    value run_list() {
        value v{true, false, true, false, {{}}};
        for (skip_lines(); more(); skip_lines()) {
            std::size_t times = 1;
            if (at_ + 2 < end_ && here().is == token::kind::number && is_sign(tokens_[at_ + 1], "*")) {
                times =
                    here().text.size() < 4 && here().text.find('.') == nowhere ? std::stoul(here().text) : 0;
                at_ += 2;
            }
            const value next = sum();
            if (next.is_array || times == 0) fail("a list in a list");
            v.rows[0].insert(v.rows[0].end(), times, next.rows[0][0]);
            skip_lines();
            if (more() && !accept(",")) fail("'" + here().text + "'");
        }
        return v;
    }

  private:
    value sum() {
        if (++depth_ > 100) fail("more than 100 levels of brackets");
        value v = product();
        for (skip_lines_before_operator(); more() && (sign("+") || sign("-")) && !separates(here());
             skip_lines_before_operator()) {
            const std::string op = tokens_[at_++].text;
            v = combined(std::move(v), op, product());
        }
        --depth_;
        return v;
    }

    value product() {
        value v = signed_power();
        for (skip_lines_before_operator(); more(); skip_lines_before_operator()) {
            const bool times = sign("*") || sign(".*"), divided = sign("/") || sign("./") || sign("//");
            const bool adjacent = !here().blank_before && tokens_[at_ - 1].is == token::kind::number &&
                                  (here().is == token::kind::word || sign("(") || sign("\xE2\x88\x9A"));
            if (!times && !divided && !adjacent) break;
            if (!adjacent) ++at_;
            v = combined(std::move(v), divided ? "/" : "*", signed_power());
        }
        return v;
    }

    value signed_power() {
        if (more() && (sign("-") || sign("+"))) {
            if (++depth_ > 100) fail("more than 100 signs");
            const bool minus = tokens_[at_++].text == "-";
            value v = signed_power();
            --depth_;
            if (!minus) return v;
            for (auto& row : v.rows)
                for (auto& c : row) c.text = bounded("-" + operand(c.text));
            return v;
        }
        value v = postfix();
        if (!accept("^") && !accept("**") && !accept(".^")) return v;
        const value exponent = signed_power();
        if (v.is_array || exponent.is_array) fail("a power of an array");
        return combined(std::move(v), "^", exponent);
    }

    value postfix() {
        value v = primary();
        for (skip_lines_before_operator(); more(); skip_lines_before_operator()) {
            if ((sign("'") || sign(".'")) && !here().blank_before) {
                ++at_;
                transpose(v);
            } else if (sign(".") && at_ + 1 < end_ && tokens_[at_ + 1].is == token::kind::word) {
                ++at_;
                apply_method(v);
            } else {
                break;
            }
        }
        return v;
    }

    void apply_method(value& v) {
        const auto method = std::find_if(methods.begin(), methods.end(),
                                         [&](const auto& m) { return m.first == here().text; });
        if (method == methods.end()) fail("'." + here().text + "'");
        ++at_;
        bool by_columns = false;
        if (sign("(")) {
            const auto close = closing();
            for (; at_ < close; ++at_)
                by_columns = by_columns || (here().is == token::kind::text && here().text == "F");
            ++at_;
        }
        if (method->second == call_does::transpose) transpose(v);
        if (method->second == call_does::by_rows) reshape(v, by_columns);
    }

    value primary() {
        skip_lines();
        if (!more()) fail("it ends too early");
        const token& t = here();
        if (t.is == token::kind::number) return number_value(tokens_[at_++].text, t.line);
        if (t.is == token::kind::text) return quoted();
        if (accept("&")) return primary();
        if (accept("\xE2\x88\x9A")) {
            const value x = primary();
            if (x.is_array) fail("a root of an array");
            return number_value(bounded("sqrt(" + x.rows[0][0].text + ")"), t.line);
        }
        if (sign("@")) {  // Julia's @SVector [...]
            at_ += 2;
            return primary();
        }
        if (sign("[") || sign("{")) return brackets();
        if (sign("(")) return parentheses();
        if (t.is == token::kind::word) return word();
        fail(t.is == token::kind::line_end ? "the line ends" : "'" + t.text + "'");
    }

    /// A number in quotes.
    value quoted() {
        const std::string text = here().text;
        const auto line = here().line;
        if (text.empty() || text.find_first_not_of("0123456789.eE+-/ ") != text.npos)
            fail("\"" + text + "\"");
        ++at_;
        return number_value(operand(text), line);
    }

    /// A number in parentheses, or a tuple.
    value parentheses() {
        const auto close = closing();
        std::vector<value> parts = arguments(close, close, false);
        if (parts.size() != 1 || is_sign(tokens_[close - 1], ",")) return list(std::move(parts));
        if (!parts.front().is_array) parts.front().rows[0][0].text = operand(parts.front().rows[0][0].text);
        return std::move(parts.front());
    }

    /// The values in the parentheses that are here, up to `stop`. Left out are types and kinds, where a call may have
    /// some and behind arrays: "convert(T, 1//2)", "real(0.5, dp)", "np.array([1, 2], float)".
    std::vector<value> arguments(std::size_t stop, std::size_t close, bool with_types) {
        const auto outer = enter(stop, {});
        std::vector<value> parts;
        for (skip_lines(); more(); skip_lines()) {
            const bool type = here().is == token::kind::word &&
                              (with_types || (!parts.empty() && parts.back().is_array)) && is_type(stop);
            if (type)
                while (more() && !sign(",")) ++at_;
            else
                parts.push_back(sum());
            skip_lines();
            if (more() && !accept(",")) fail("'" + here().text + "'");
        }
        leave(outer, close);
        return parts;
    }

    /// A word that is not known, perhaps with points in it, up to a comma or the end.
    bool is_type(std::size_t stop) const {
        if (known_(here().text)) return false;
        for (auto i = at_; i < stop && !is_sign(tokens_[i], ","); ++i)
            if (tokens_[i].is != token::kind::word && !is_sign(tokens_[i], ".")) return false;
        return true;
    }

    /// "[1, 2]", "[[1], [2]]", "[1 2; 3 4]", rows apart by lines.
    value brackets() {
        const auto close = closing();
        if (auto difference = zipped(close)) return *std::move(difference);
        bool commas = false;
        for (auto i = at_ + 1; i < close && !commas; ++i) {
            if (is_open(tokens_[i]) && tokens_[i].partner < close) i = tokens_[i].partner;
            commas = is_sign(tokens_[i], ",");
        }
        if (!commas && is_repeated_zero(at_ + 1, close)) {
            at_ = close + 1;
            return {true, false, false, false, {}};
        }
        auto first = at_ + 1;
        while (first < close && tokens_[first].is == token::kind::line_end) ++first;
        const bool keys = sign("{") && first + 1 < close && tokens_[first].is == token::kind::number &&
                          is_sign(tokens_[first + 1], ":");
        const auto outer = enter(close, {!commas, true});
        std::vector<std::vector<value>> rows(1);
        bool new_row = false, comma = true;
        while (more()) {
            if (here().is == token::kind::line_end || sign(";")) {
                new_row = !rows.back().empty() && (sign(";") || !comma);
                if (sign(";") && at_ + 1 < end_ && is_sign(tokens_[at_ + 1], ";")) fail("';;'");
                ++at_;
                continue;
            }
            if (accept(",")) {
                if (comma) fail("',,'");
                comma = true;
                new_row = false;
                continue;
            }
            if (new_row) rows.emplace_back();
            new_row = false;
            if (!comma && !here().blank_before && !is_open(here())) fail("'" + here().text + "'");
            if (keys && comma) skip_key();
            rows.back().push_back(keys && is_nothing() ? nothing() : sum());
            comma = false;
        }
        leave(outer, close);
        return of_rows(std::move(rows));
    }

    /// Python's [x - y for x, y in zip(b, b_hat)], number by number.
    std::optional<value> zipped(std::size_t close) {
        static constexpr std::array<std::string_view, 14> pattern{"?",  "-",   "?", "for", "?", ",", "?",
                                                                  "in", "zip", "(", "?",   ",", "?", ")"};
        const auto word = [&](std::size_t k) -> const std::string& { return tokens_[at_ + 1 + k].text; };
        if (close != at_ + 1 + pattern.size()) return std::nullopt;
        for (std::size_t k = 0; k < pattern.size(); ++k)
            if (pattern[k] != "?" && pattern[k] != word(k)) return std::nullopt;
        const value *x = known_(word(10)), *y = known_(word(12));
        if (!x || !y || word(0) != word(4) || word(2) != word(6)) return std::nullopt;
        at_ = close + 1;
        return combined(*x, "-", *y);
    }

    /// Rust's [0.0; 4] and [[0.0; 4]; 4], to be filled.
    bool is_repeated_zero(std::size_t first, std::size_t close) const {
        if (close < first + 3 || !is_sign(tokens_[close - 2], ";")) return false;
        const token& t = tokens_[first];
        if (is_sign(t, "[")) return t.partner + 3 == close && is_repeated_zero(first + 1, t.partner);
        return first + 3 == close && t.is == token::kind::number && t.text.find('.') != nowhere &&
               t.text.find_first_not_of("0.") == nowhere;
    }

    /// Python's {0: [1/2], 1: None}: the keys count the rows.
    void skip_key() {
        if (here().is == token::kind::number && at_ + 1 < end_ && is_sign(tokens_[at_ + 1], ":")) at_ += 2;
        skip_lines();
    }
    bool is_nothing() const { return more() && here().is == token::kind::word && here().text == "None"; }
    value nothing() {
        ++at_;
        return {true, false, false, false, {}};
    }

    /// "np.array", "Rational{Int}", "std::sqrt": the name, with the type behind it left out.
    std::string name() {
        std::string text = tokens_[at_++].text;
        while (at_ + 1 < end_ && (sign(".") || sign("::") || sign("->")) &&
               tokens_[at_ + 1].is == token::kind::word && !here().blank_before &&
               !(is_method(at_ + 1) && known_(text))) {
            text += here().text + tokens_[at_ + 1].text;
            at_ += 2;
        }
        accept("!");                                                               // Rust's vec![...]
        if (sign(".") && at_ + 1 < end_ && is_sign(tokens_[at_ + 1], "(")) ++at_;  // Julia's T.(...)
        skip_template();
        if (sign("{") && !here().blank_before) {
            const auto close = closing();
            if (close + 1 < end_ && is_open(tokens_[close + 1])) at_ = close + 1;
        }
        return text;
    }

    /// "<double, 2>" before a bracket.
    void skip_template() {
        if (!sign("<")) return;
        int depth = 0;
        for (auto i = at_; i < std::min(end_, at_ + 24); ++i) {
            const auto& t = tokens_[i];
            depth += is_sign(t, "<") ? 1 : is_sign(t, ">") ? -1 : is_sign(t, ">>") ? -2 : 0;
            if (depth > 0) continue;
            if (i + 1 < end_ && is_open(tokens_[i + 1])) at_ = i + 1;
            return;
        }
    }

    bool is_method(std::size_t k) const {
        return std::any_of(methods.begin(), methods.end(),
                           [&](const auto& m) { return m.first == tokens_[k].text; });
    }

    value word() {
        const auto line = here().line;
        const std::string full = name();
        const std::string last(last_part(full));
        if (more() && here().is == token::kind::text && is_wrapper(last)) return quoted();  // big"0.1"
        const bool behind = more() && !here().blank_before;
        if (behind)
            if (const value* v = element_of(full)) return *v;
        if (behind && sign("(")) return call(full, last, line);
        if (behind && (sign("[") || sign("{"))) {
            const bool type = is_wrapper(last) || std::isupper(static_cast<unsigned char>(last[0]));
            if (!type || known_(full) || (last.size() == 1 && last != "T"))
                fail("'" + full + "[...]', an element of it,");
            return brackets();
        }
        if (sign("[") && is_wrapper(last)) return brackets();
        if (const value* v = known_(full)) return *v;
        if (last == "pi" || last == "π") return number_value("pi", line);
        if (last == "one") return number_value("1", line);
        throw not_understood{"'" + full + "' is unknown", line};
    }

    /// The value of "b[0]", "A[1][0]", "A(2, 1)", if it is known.
    const value* element_of(const std::string& full) {
        std::string element = full;
        auto i = at_;
        while (i < end_ && (is_sign(tokens_[i], "[") || is_sign(tokens_[i], "(")) &&
               tokens_[i].partner < end_) {
            for (const auto close = tokens_[i].partner; ++i < close;) {
                if (tokens_[i].is == token::kind::number) element += "[" + tokens_[i].text + "]";
                if (tokens_[i].is != token::kind::number && !is_sign(tokens_[i], ",")) return nullptr;
            }
            ++i;
        }
        const value* v = i == at_ ? nullptr : known_(element);
        if (v) at_ = i;
        return v;
    }

    value call(const std::string& full, const std::string& last, std::size_t line) {
        const auto close = closing();
        auto does = std::find_if(calls.begin(), calls.end(), [&](const auto& c) { return c.name == full; });
        if (does == calls.end())
            does = std::find_if(calls.begin(), calls.end(), [&](const auto& c) { return c.name == last; });
        const bool wrapped = does == calls.end();
        if (known_(full) || (last.size() == 1 && std::string_view("ABCDE").find(last) != nowhere))
            fail("'" + full + "(...)', an element of it,");
        if (wrapped && !is_wrapper(last)) fail("'" + full + "(...)'");
        if (!wrapped && does->does == call_does::zeros) {
            at_ = close + 1;
            return {true, false, false, false, {}};
        }
        const auto [stop, by_rows, by_columns] = named_arguments_of(tokens_, at_);
        static constexpr std::array<std::string_view, 6> typed{"convert", "parse", "real",
                                                               "map",     "float", "ones"};
        const bool types = std::find(typed.begin(), typed.end(), last) != typed.end();
        std::vector<value> parts = arguments(stop, close, types);
        if (parts.empty()) fail("'" + full + "()'");
        value v = wrapped ? wrapped_value(full, std::move(parts))
                          : value_of_call(does->does, last, std::move(parts), line);
        if (v.reshaped && by_rows) v.by_columns = false;
        if (v.reshaped && by_columns) v.by_columns = true;
        return v;
    }

    const lookup& known_;
    int depth_ = 0;
};

STAGECRAFT_INLINE value value_of(const std::vector<token>& tokens, std::size_t begin, std::size_t end,
                                 const lookup& known) {
    value_parser parser(tokens, begin, end, known);
    return parser.located([&] { return parser.run(); });
}

STAGECRAFT_INLINE value list_of(const std::vector<token>& tokens, std::size_t begin, std::size_t end,
                                const lookup& known) {
    value_parser parser(tokens, begin, end, known);
    return parser.located([&] { return parser.run_list(); });
}

}  // namespace stagecraft::tableaux::program_text
