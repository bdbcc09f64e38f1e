// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_scan.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/program_names.hpp"

namespace stagecraft::tableaux::program_text {

STAGECRAFT_INLINE bool program::related(std::size_t x, std::size_t y) const {
    const auto within = [&](std::size_t inner, std::size_t outer) {
        for (int i = 0; i < deepest_scope && inner != nowhere; ++i, inner = scopes[inner].parent)
            if (inner == outer) return true;
        return false;
    };
    return within(x, y) || within(y, x);
}

STAGECRAFT_INLINE std::string program::name_of(std::size_t at) const {
    for (int i = 0; i < deepest_scope && at != nowhere; ++i, at = scopes[at].parent)
        if (const auto& name = scopes[at].name; !name.empty() && name != "__init__" && name != "new")
            return name;
    return {};
}

/// Goes through the tokens once.
class scanner {
  public:
    explicit scanner(std::string_view source) {
        out_.tokens = tokens_of(source);
        out_.scopes.emplace_back();
        frames_.push_back({0, nowhere, false, 0});
        statements_.resize(out_.tokens.size() + 1);
        for (std::size_t i = 0; i < out_.tokens.size(); ++i)
            statements_[i + 1] =
                statements_[i] + (is_assign(i) || is_sign(at(i), ";") || is_sign(at(i), ":") ? 1 : 0);
    }

    program run() && {
        for (std::size_t i = 0; i < out_.tokens.size(); ++i) {
            if (i == 0 || at(i - 1).is == token::kind::line_end) begin_line(i);
            if (is_open(at(i)) && at(i).partner != nowhere) {
                if (is_sign(at(i), "{") && i > 0 && !at(i).blank_before) take_braces(i);
                if (is_sign(at(i), "(")) take_call(i);
                take_initializer(i);
                open(i);
            } else if (is_close(at(i)) && at(i).partner != nowhere) {
                close(i);
            } else if (is_assign(i) && i != assigned_) {
                take(i, i + 1);
            } else if (is_sign(at(i), ":")) {
                take_colon(i);
            } else if (is_word(i) && at(i).text == "return") {
                take_return(i);
            }
        }
        return std::move(out_);
    }

  private:
    struct frame {
        std::size_t scope, close;  ///< close: nowhere for a section
        bool by_indentation;
        std::size_t indent;
    };

    const token& at(std::size_t i) const { return out_.tokens[std::min(i, out_.tokens.size() - 1)]; }
    bool is_word(std::size_t i) const { return i < out_.tokens.size() && at(i).is == token::kind::word; }
    bool is_name(std::size_t i) const {
        return is_word(i) || (i < out_.tokens.size() && at(i).is == token::kind::text);
    }
    bool changes(std::size_t i) const {
        return is_sign(at(i), "+=") || is_sign(at(i), "-=") || is_sign(at(i), "*=") || is_sign(at(i), "/=");
    }
    bool is_assign(std::size_t i) const {
        return is_sign(at(i), "=") || is_sign(at(i), ":=") || is_sign(at(i), "=>") || is_sign(at(i), "<-") ||
               is_sign(at(i), "<<") || changes(i);
    }

    std::size_t add_scope(std::string name) {
        out_.scopes.push_back({frames_.back().scope, std::move(name)});
        return out_.scopes.size() - 1;
    }

    void open(std::size_t i) {
        std::string name = scope_name(i);
        const auto scope = name == "claims" ? frames_.back().scope : add_scope(std::move(name));
        frames_.push_back({scope, at(i).partner, false, 0});
        brackets_.push_back(i);
    }

    void close(std::size_t i) {
        while (frames_.back().close != i) frames_.pop_back();
        frames_.pop_back();
        brackets_.pop_back();
    }

    /// Ends and begins sections.
    void begin_line(std::size_t i) {
        line_begin_ = i;
        if (!brackets_.empty() && !is_sign(at(brackets_.back()), "{")) return;
        const auto indent = at(i).column;
        const auto is_section = [&] { return frames_.size() > 1 && frames_.back().close == nowhere; };
        while (is_section() && frames_.back().by_indentation && indent <= frames_.back().indent)
            frames_.pop_back();
        if (is_word(i) && at(i).text.starts_with("end") && is_section() && indent <= frames_.back().indent)
            frames_.pop_back();
        std::size_t last = i;
        while (at(last).is != token::kind::line_end) ++last;
        take_data(i, last);
        const auto [word, name] = section_at(i, last);
        if (!word || is_sign(at(last - 1), "{")) return;
        const bool colon = is_sign(at(last - 1), ":") && word->word != "case" && word->word != "default";
        const bool by_indentation = colon || word->word == "def";
        while (is_section() && indent <= frames_.back().indent) frames_.pop_back();
        frames_.push_back({add_scope(name), nowhere, by_indentation, indent});
    }

    /// The section that a line begins, and its name; null where it begins none.
    std::pair<const section_word*, std::string> section_at(std::size_t i, std::size_t last) const {
        last = std::min(last, i + 64);
        const auto modifies = [&](const token& t) {
            return std::find(section_modifiers.begin(), section_modifiers.end(), t.text) !=
                   section_modifiers.end();
        };
        while (i < last && (is_sign(at(i), "}") || modifies(at(i)))) ++i;
        if (is_sign(at(i), "@") && i + 2 < last) i += 2;  // Julia's "@fold function"
        const auto* word = std::find_if(section_words.begin(), section_words.end(),
                                        [&](const auto& w) { return is_word(i) && w.word == at(i).text; });
        if (word == section_words.end() || is_sign(at(i + 1), "=")) return {};
        std::string text, next;
        for (std::size_t k = i + 1; k < last; ++k) {
            if (text.empty() && at(k).is == token::kind::text) text = at(k).text;
            if (next.empty() && is_word(k) && at(k).text != "procedure") next = at(k).text;
        }
        // Julia's "function tableau(::Heun)".
        for (std::size_t k = i + 1; word->word == "function" && k + 3 < last; ++k)
            if (is_sign(at(k), "(") && is_sign(at(k + 1), "::") && is_word(k + 2) && is_sign(at(k + 3), ")"))
                next = at(k + 2).text;
        // Matlab's "function t = heun()".
        for (std::size_t k = i + 1; word->word == "function" && k + 1 < last; ++k) {
            if (is_open(at(k)) && at(k).partner != nowhere) k = at(k).partner;
            if (is_sign(at(k), "=") && is_word(k + 1)) next = at(k + 1).text;
        }
        using named = section_word::named;
        if (word->by == named::by_text && text.empty()) return {};
        return {word, word->by == named::by_next_word || text.empty() ? next : text};
    }

    struct found_name {
        std::string name;
        std::size_t begin = nowhere;  ///< its first token
        std::vector<std::size_t> index;
    };

    /// The name that ends before token `end`: a word with what it is part of, or a text, before sizes or an index.
    found_name name_before(std::size_t end) const {
        found_name out;
        if (end == 0) return out;
        std::size_t k = annotated_before(end);
        while (k > 0 && (is_sign(at(k), "]") || is_sign(at(k), ")")) && at(k).partner != nowhere &&
               at(k).partner > 0) {
            out.index.insert(out.index.begin(), at(k).partner);
            k = at(k).partner - 1;
        }
        if (!out.index.empty() && is_this(out.index.front())) {  // "(*this)[0]": the array is the class
            out.name = out_.scopes[frames_.back().scope].name;
            out.begin = out.index.front();
            out.index.erase(out.index.begin());
            return out;
        }
        if (!is_name(k)) return out;
        out.name = at(k).text;
        out.begin = k;
        const auto joins = [&](std::size_t sign) {
            return (is_sign(at(sign), ".") || is_sign(at(sign), "->") || is_sign(at(sign), "::")) &&
                   !at(sign).blank_before && !at(sign + 1).blank_before;
        };
        while (out.begin >= 2 && is_word(k) && joins(out.begin - 1) && is_word(out.begin - 2)) {
            out.name = at(out.begin - 2).text + at(out.begin - 1).text + out.name;
            out.begin -= 2;
        }
        return out;
    }

    bool is_this(std::size_t open) const {
        return is_sign(at(open), "(") && is_sign(at(open + 1), "*") && at(open + 2).text == "this" &&
               at(open).partner == open + 3;
    }

    /// The scope around the class whose function is here.
    std::size_t around_class() const {
        const auto inner = out_.scopes[frames_.back().scope].parent;
        const auto parent = inner == nowhere ? nowhere : out_.scopes[inner].parent;
        return parent == nowhere ? frames_.back().scope : parent;
    }

    /// The last token of the name before `end`, where a type may stand between: "HEUN: Tableau<2> =".
    std::size_t annotated_before(std::size_t end) const {
        std::size_t k = end - 1;
        for (int steps = 0; steps < 24 && k > 0; ++steps, --k) {
            const auto& t = at(k);
            if (is_close(t) && t.partner != nowhere)
                k = t.partner;
            else if (is_sign(t, ":") && is_name(k - 1) && k + 1 < end && !section_at(line_begin_, k).first)
                return k - 1;
            else if (t.is == token::kind::line_end || t.is == token::kind::text || is_open(t) ||
                     is_assign(k) || is_sign(t, ",") || is_sign(t, ";"))
                break;
        }
        return end - 1;
    }

    /// What a bracket belongs to: "heun = {", "heun = dict(", "struct heun {", "MACRO(HEUN, {", "(\"heun\", ...".
    std::string scope_name(std::size_t i) const {
        if (at(i + 1).is == token::kind::text && is_sign(at(i + 2), ",")) return at(i + 1).text;
        if (i == 0) return {};
        std::size_t k = i - 1;
        if (is_sign(at(k), ">")) return is_assign(k) ? name_before(k).name : std::string();
        const bool after_word = is_word(k);
        while (k > 0 && (is_word(k) || is_sign(at(k), ".") || is_sign(at(k), "::"))) --k;
        if (is_assign(k) || (is_sign(at(k), ":") && is_name(k - (k > 0 ? 1 : 0)))) return name_before(k).name;
        if (!is_sign(at(i), "{")) return {};
        if (at(i - 1).is == token::kind::line_end) {  // a function whose body begins on a line of its own
            const auto last = i > 1 ? i - 2 : 0;
            if (!is_sign(at(last), ")") || at(last).partner == nowhere) return {};
            return name_before(at(last).partner).name;
        }
        if (is_sign(at(i - 1), ",") && !brackets_.empty() && is_word(brackets_.back() + 1) &&
            is_sign(at(brackets_.back() + 2), ","))
            return at(brackets_.back() + 1).text;
        if (const auto [word, name] = section_at(line_begin_, i); word) return name;
        if (after_word) return at(i - 1).text;
        if (is_sign(at(i - 1), ")") && at(i - 1).partner != nowhere)
            return name_before(at(i - 1).partner).name;
        return {};
    }

    /// Where the value that begins at `begin` ends; brackets that are not closed are told.
    std::size_t end_of_value(std::size_t begin, bool list, bool& closed) const {
        std::size_t i = begin;
        for (; i < out_.tokens.size(); ++i) {
            const token& t = at(i);
            if (t.is == token::kind::line_end) {
                const bool empty = std::all_of(out_.tokens.begin() + static_cast<std::ptrdiff_t>(begin),
                                               out_.tokens.begin() + static_cast<std::ptrdiff_t>(i),
                                               [](const token& x) { return x.is == token::kind::line_end; });
                const token& next = at(i + 1);
                static constexpr std::string_view operators("+-*/.");
                const auto is_operator = [&](const token& x) {
                    return x.is == token::kind::sign && operators.find(x.text[0]) != operators.npos &&
                           !is_sign(x, "...");
                };
                const bool goes_on = is_operator(next) || (i > begin && is_operator(at(i - 1)));
                if (!empty && !goes_on && !(list && is_sign(at(i - 1), ","))) break;
            }
            if (is_open(t)) {
                closed = t.partner != nowhere;
                if (!closed) break;
                i = t.partner;
                continue;
            }
            if (is_close(t) || is_sign(t, ";") || (is_sign(t, ",") && !list) || is_assign(i) ||
                is_sign(t, ":") || (t.is == token::kind::word && t.text == "return"))
                break;
        }
        return i;
    }

    void take(std::size_t sign, std::size_t begin) {
        if (is_assign(sign)) assigned_ = sign;
        auto found = name_before(sign);
        if (found.name.empty()) return;
        assignment a{std::move(found.name), frames_.back().scope, at(sign > 0 ? sign - 1 : 0).line, begin};
        a.line = at(found.begin).line;
        if (is_this(found.begin)) a.scope = around_class();
        a.sign = sign;
        a.list = is_sign(at(sign), "<<");
        a.end = end_of_value(begin, a.list, a.closed);
        for (int chained = 0; chained < 4 && is_sign(at(a.end), "=") && is_sign(at(sign), "="); ++chained) {
            a.begin = a.end + 1;  // "x = y = 1"
            a.end = end_of_value(a.begin, false, a.closed);
        }
        a.changes = changes(sign);
        const auto before = found.begin == 0 ? nowhere : found.begin - 1;
        a.one_of_many = before != nowhere && is_sign(at(before), ",");
        const bool statement = before == nowhere || at(before).is == token::kind::line_end ||
                               is_sign(at(before), ";") || is_sign(at(before), "{") ||
                               is_sign(at(before), "}") || is_sign(at(before), ":") ||
                               is_sign(at(before), "=");
        a.element = statement && !found.index.empty();
        a.index = std::move(found.index);
        out_.assignments.push_back(std::move(a));
    }

    /// "A: [[...", but no type as in "A: array = ..." and no block as in "class X:".
    void take_colon(std::size_t i) {
        if (i == 0 || !is_name(i - 1)) return;
        if (at(i + 1).is == token::kind::line_end && at(i - 1).is != token::kind::text) return;
        std::size_t k = i + 1;
        for (int steps = 0; steps < 24 && k < out_.tokens.size(); ++steps, ++k) {
            if (is_sign(at(k), "=")) return;  // taken there
            if (is_open(at(k)) && at(k).partner != nowhere)
                k = at(k).partner;
            else if (at(k).is == token::kind::line_end || is_close(at(k)) || is_sign(at(k), ",") ||
                     is_sign(at(k), ";") || at(k).is == token::kind::number)
                break;
        }
        take(i, i + 1);
    }

    /// "std::array<double, 2> b{0, 1}", but no body and no type as Rational{Int}.
    void take_braces(std::size_t i) {
        const auto close = at(i).partner;
        if (!is_word(i - 1) || statements_[close] != statements_[i] || is_open(at(close + 1)) ||
            close == i + 1)
            return;
        auto found = name_before(i);
        if (claim_in(found.name)) return;  // take_initializer's
        assignment a{std::move(found.name), frames_.back().scope, at(found.begin).line, i, close + 1};
        a.sign = i;
        out_.assignments.push_back(std::move(a));
    }

    /// "order(4)" and "order{4}" of C++.
    void take_initializer(std::size_t i) {
        if (i == 0 || !is_word(i - 1) || at(i + 1).is != token::kind::number || at(i).partner != i + 2)
            return;
        auto found = name_before(i);
        if (!claim_in(found.name)) return;
        assignment a{std::move(found.name), frames_.back().scope, at(i).line, i + 1, i + 2};
        a.sign = i;
        out_.assignments.push_back(std::move(a));
    }

    void take_call(std::size_t i) {
        if (i == 0 || !is_word(i - 1)) return;
        const auto* call = std::find_if(register_calls.begin(), register_calls.end(),
                                        [&](const auto& r) { return r.function == at(i - 1).text; });
        if (call == register_calls.end()) return;
        auto scope = frames_.rbegin();  // not that of a call around it
        int steps = 0;
        for (auto bracket = brackets_.rbegin();
             steps < deepest_scope && bracket != brackets_.rend() && is_sign(at(*bracket), "(");
             ++bracket, ++steps) {
            while (scope->close == nowhere) ++scope;
            ++scope;
        }
        out_.registrations.push_back({at(i - 1).text, scope->scope, at(i).line, i});
    }

    /// "def order(self): return 4", "int order() const { return 4; }": a value of the function's name.
    void take_return(std::size_t i) {
        const auto& here = out_.scopes[frames_.back().scope];
        if (here.name.empty() || here.parent == nowhere) return;
        assignment a{here.name, here.parent, at(i).line, i + 1};
        a.returned = true;
        a.sign = i;
        a.end = end_of_value(i + 1, false, a.closed);
        out_.assignments.push_back(std::move(a));
    }

    /// Fortran's "DATA A /0, 1/".
    void take_data(std::size_t i, std::size_t last) {
        if (!is_word(i) || at(i).text.size() != 4) return;
        std::string word = at(i).text;
        std::transform(word.begin(), word.end(), word.begin(),
                       [](unsigned char ch) { return std::tolower(ch); });
        if (word != "data") return;
        for (std::size_t k = i + 1; k < last;) {
            if (!is_word(k) || !is_sign(at(k + 1), "/")) return;
            std::size_t end = k + 2;
            while (end < last && !is_sign(at(end), "/")) ++end;
            assignment a{at(k).text, frames_.back().scope, at(k).line, k + 2, end};
            a.sign = k;
            a.list = a.by_columns = true;
            out_.assignments.push_back(std::move(a));
            k = end + 1 + (is_sign(at(end + 1), ",") ? 1 : 0);
        }
    }

    program out_;
    std::vector<frame> frames_;
    std::vector<std::size_t> brackets_;
    std::vector<std::size_t> statements_;  ///< how many tokens before each separate or make statements
    std::size_t line_begin_ = 0, assigned_ = nowhere;
};

STAGECRAFT_INLINE program scan(std::string_view source) { return scanner(source).run(); }

}  // namespace stagecraft::tableaux::program_text
