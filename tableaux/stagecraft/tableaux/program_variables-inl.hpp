// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_variables.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/number_brackets.hpp"
#include "stagecraft/tableaux/program_names.hpp"

namespace stagecraft::tableaux::program_text {

/// Reads the values of a program's assignments.
class variable_reader {
  public:
    explicit variable_reader(const program& p) : p_(p), brackets_(p.tokens) {
        numbers_.resize(p.tokens.size() + 1);
        statements_.resize(p.tokens.size() + 1);
        for (std::size_t i = 0; i < p.tokens.size(); ++i) {
            const token& t = p.tokens[i];
            const bool statement = is_sign(t, "=") || is_sign(t, "=>") || is_sign(t, ":") ||
                                   (is_sign(t, ";") && i > 0 && is_sign(p.tokens[i - 1], ")"));
            numbers_[i + 1] = numbers_[i] + (brackets_.at(i) ? 1 : 0);
            statements_[i + 1] = statements_[i] + (statement ? 1 : 0);
        }
    }

    variables run() && {
        for (const auto& a : p_.assignments) {
            if (a.sign >= covered_from_ && a.sign < covered_) continue;  // part of a value that is read
            if (!a.closed && !p_.tokens.empty()) require_closed(a);
            if (a.changes)
                change(a);
            else if (a.element)
                take_element(a);
            else
                take(a);
        }
        place_elements();
        find_unnamed();
        return std::move(out_);
    }

  private:
    void require_closed(const assignment& a) const {
        const auto last = last_part(a.name);
        const bool coefficient = last.size() == 1 || last.find("_A") != last.npos ||
                                 last.find("A_") != last.npos || last.starts_with("b") ||
                                 last.ends_with("_b") || last.ends_with("_c");
        std::size_t i = a.begin;
        while (i < a.end && !is_open(p_.tokens[i])) ++i;
        const bool array = a.end < p_.tokens.size() && !is_sign(p_.tokens[a.end], "(");
        if (coefficient && array)
            throw std::invalid_argument("line " + std::to_string(a.line) + ", " + a.name +
                                        ": the brackets are not closed");
    }

    variable& add(const assignment& a, variable::kind is) {
        const auto end = std::max(a.begin + 1, std::min(a.end, p_.tokens.size()));
        out_.all.push_back({a.name,
                            a.scope,
                            a.line,
                            p_.tokens[end - 1].line,
                            is,
                            {},
                            {},
                            {},
                            {},
                            false,
                            a.returned,
                            false,
                            false});
        return out_.all.back();
    }

    /// What a name stands for; it is used then.
    const value* find(const std::string& name) {
        if (name.ends_with(']')) {
            const auto at = element_values_.find({scope_, name});
            if (at != element_values_.end()) return &at->second;
            // "B->b[1]" beside "B->b[0] = ..." in C: the memory was 0.
            const auto array = name.substr(0, name.find('['));
            return array.find("->") != array.npos && of_elements_.contains({scope_, array}) ? &zero_
                                                                                            : nullptr;
        }
        auto at = known_.find(name);
        if (at == known_.end()) at = known_.find(std::string(last_part(name)));
        if (at == known_.end()) return nullptr;
        // Elements are placed at the end: before, only "a = convert(a)" may hand on an array that has some.
        const bool same = out_.all[at->second].scope == scope_ && out_.all[at->second].name == assigned_;
        if (written_.contains(at->second) && !same) return nullptr;
        out_.all[at->second].used = true;
        found_.push_back(at->second);
        return &out_.all[at->second].array;
    }

    void remember(std::size_t k) {
        known_[out_.all[k].name] = k;
        known_[std::string(out_.all[k].last())] = k;
    }

    std::optional<value> read(const assignment& a, std::string& trouble) {
        scope_ = a.scope;
        assigned_ = a.name;
        found_.clear();
        const lookup known = [this](const std::string& name) { return find(name); };
        try {
            auto v = a.list ? list_of(p_.tokens, a.begin, a.end, known)
                            : value_of(p_.tokens, a.begin, a.end, known);
            if (a.by_columns) v.by_columns = true;
            cover(a);
            for (const auto k : found_) out_.all[k].in_array = out_.all[k].in_array || v.is_array;
            return v;
        } catch (const not_understood& e) {
            trouble = e.what.ends_with("unknown") ? e.what : e.what + " is not understood";
            if (e.line != a.line) trouble += " (line " + std::to_string(e.line) + ")";
            return std::nullopt;
        }
    }

    /// What stands in the value is read, or told by its name.
    void cover(const assignment& a) {
        covered_from_ = a.begin;
        covered_ = a.end;
        ranges_.emplace_back(a.begin, a.end);
    }

    void take(const assignment& a) {
        if (take_word(a) || is_copy(a)) return;
        const auto before = known_.find(a.name);
        const auto old = before == known_.end() ? nowhere : before->second;
        const bool was_used = old != nowhere && std::exchange(out_.all[old].used, false);
        std::string trouble;
        auto v = read(a, trouble);
        // "A = A/2" changes A, where it stands in the same scope.
        const bool replaces = old != nowhere && out_.all[old].used && out_.all[old].scope == a.scope;
        if (old != nowhere) out_.all[old].used = was_used || (out_.all[old].used && !replaces);
        if (v && replaces) {
            out_.all[old].array = std::move(*v);
            return;
        }
        if (v) {
            auto& x = add(a, v->is_array ? variable::kind::array : variable::kind::number);
            x.array = std::move(*v);
            remember(out_.all.size() - 1);
            return;
        }
        known_.erase(a.name);
        known_.erase(std::string(last_part(a.name)));
        if (a.sign > 1 && is_sign(p_.tokens[a.sign - 2], "*") && numbers_[a.end] == numbers_[a.begin])
            pointers_.emplace_back(a.scope, a.name);
        const bool single = !a.one_of_many && is_single_coefficient(last_part(a.name));
        if (!holds_numbers(a) && !is_list_of_coefficients(a) && !is_claim(a) && !single) return;
        const bool array = holds_numbers(a) || is_list_of_coefficients(a);
        add(a, array ? variable::kind::array : variable::kind::other).trouble = std::move(trouble);
        cover(a);
    }

    /// "A = A" hands a name on to a call.
    bool is_copy(const assignment& a) const {
        return a.end == a.begin + 1 && p_.tokens[a.begin].text == a.name && known_.contains(a.name);
    }

    /// "c = [0, x]" with an x that is not known: a bracket that is no index, and a number, behind a coefficient's name.
    bool is_list_of_coefficients(const assignment& a) const {
        if (!is_coefficient(last_part(a.name)) || statements_[a.end] != statements_[a.begin]) return false;
        bool list = false, number = false;
        for (auto i = a.begin; i < std::min(a.end, a.begin + 64); ++i) {
            const token& t = p_.tokens[i];
            const bool index = i > a.begin && !t.blank_before &&
                               (p_.tokens[i - 1].is == token::kind::word || is_close(p_.tokens[i - 1]));
            list = list || ((is_sign(t, "[") || is_sign(t, "{")) && !index);
            number = number || (list && t.is == token::kind::number);
        }
        return list && number;
    }

    /// "order = p" with a p that is not known, but no "order = order" of an argument.
    bool is_claim(const assignment& a) const {
        const auto claim = claim_in(a.name);
        static constexpr std::array<std::string_view, 7> nothing{"NotImplemented", "None", "usize",  "int",
                                                                 "integer",        "null", "nothing"};
        if (a.end > a.begin &&
            std::find(nothing.begin(), nothing.end(), p_.tokens[a.begin].text) != nothing.end())
            return false;
        auto last = a.end;
        while (last > a.begin && p_.tokens[last - 1].is == token::kind::line_end) --last;
        const bool handed_on =
            last > a.begin && p_.tokens[last - 1].text == last_part(a.name);  // order = it->order
        return claim && claim->key != "name" && a.name.find("->") == a.name.npos && a.end > a.begin &&
               a.end < a.begin + 8 && p_.tokens[a.begin].text != last_part(a.name) && !handed_on;
    }

    /// Whether brackets with numbers stand in a value that is not understood, and nothing is assigned in it.
    bool holds_numbers(const assignment& a) const {
        return numbers_[a.end] > numbers_[a.begin] && statements_[a.end] == statements_[a.begin];
    }

    /// A text, true or false.
    bool take_word(const assignment& a) {
        std::size_t begin = a.begin, end = a.end;
        while (begin < end && p_.tokens[end - 1].is == token::kind::line_end) --end;
        if (end == begin + 3 && is_sign(p_.tokens[begin], ".") && is_sign(p_.tokens[begin + 2], ".")) {
            ++begin;  // .true.
            --end;
        }
        if (end != begin + 1) return false;
        const token& t = p_.tokens[begin];
        std::string word = t.text;
        std::transform(word.begin(), word.end(), word.begin(),
                       [](unsigned char ch) { return std::tolower(ch); });
        const bool flag = t.is == token::kind::word && (word == "true" || word == "false");
        if (!flag && t.is != token::kind::text) return false;
        add(a, flag ? variable::kind::flag : variable::kind::text).text = flag ? word : t.text;
        return true;
    }

    /// Numbers in the index brackets "[1][0]", "(2, 1)", "[1, :]"; a colon is `all`.
    static constexpr std::size_t all = nowhere - 1;
    std::optional<std::vector<std::size_t>> index_of(const assignment& a) {
        std::vector<std::size_t> index;
        for (const auto open : a.index) {
            if (p_.tokens[open].partner == nowhere) return std::nullopt;
            for (auto i = open + 1; i < p_.tokens[open].partner; ++i) {
                const token& t = p_.tokens[i];
                const bool whole =
                    t.is == token::kind::number && t.text.size() < 4 && t.text.find('.') == nowhere;
                if (is_sign(t, ",")) continue;
                if (whole && !index.empty() && index.back() == all && is_sign(p_.tokens[i - 1], ":")) {
                    from_ = 0;  // Python's A[2, :2]
                    continue;
                }
                if (!whole && !is_sign(t, ":")) return std::nullopt;
                index.push_back(whole ? std::stoul(t.text) : all);
            }
        }
        if (index.empty() || index.size() > 2) return std::nullopt;
        return index;
    }

    struct write {
        std::size_t variable;
        std::vector<std::size_t> index;
        value number;
    };

    void take_element(const assignment& a) {
        // What a pointer to elsewhere, "double *b = work + s", is filled with is no table of the program.
        for (const auto& [scope, name] : pointers_)
            if (name == a.name && p_.related(scope, a.scope)) return;
        const auto index = index_of(a);
        std::string trouble;
        const auto v = read(a, trouble);
        const bool row =
            v && v->is_array && !v->nested && index && (index->size() == 1 || index->back() == all);
        const bool number = v && !v->is_array && index && std::count(index->begin(), index->end(), all) == 0;
        const auto k = element_variable(a);
        if (row || number) {
            for (const auto i : *index)
                if (i == 0) from_ = 0;
            if (number) {
                std::string element = a.name;
                for (const auto i : *index) element += "[" + std::to_string(i) + "]";
                element_values_[{a.scope, element}] = *v;
            }
            writes_.push_back({k, *index, std::move(*v)});
            written_.insert(k);
        } else if (out_.all[k].trouble.empty()) {
            out_.all[k].trouble = index && !trouble.empty()
                                      ? trouble
                                      : "line " + std::to_string(a.line) + " computes elements of it";
        }
    }

    /// The variable of the same name and scope, or in one around it, whose elements are assigned.
    std::size_t element_variable(const assignment& a) {
        const auto before = known_.find(a.name);
        if (before != known_.end() && p_.related(out_.all[before->second].scope, a.scope) &&
            out_.all[before->second].is == variable::kind::array)
            return before->second;
        const auto [at, is_new] = of_elements_.try_emplace({a.scope, a.name}, out_.all.size());
        if (is_new) {
            auto& x = add(a, variable::kind::array);
            x.array.is_array = x.by_elements = true;
        }
        return at->second;
    }

    /// Counted from 0 if any index of the program is 0.
    void place_elements() {
        for (const auto& w : writes_) {
            auto& x = out_.all[w.variable];
            const auto row = w.index.front() - from_;
            if (!w.number.is_array) {
                x.elements.push_back(
                    {w.index.size() == 2 ? row : 0, w.index.back() - from_, w.number.rows[0][0]});
                if (w.index.size() == 1) x.elements.back().row = 0;
                continue;
            }
            std::size_t column = 0;
            for (const auto& c : w.number.all()) x.elements.push_back({row, column++, c});
        }
    }

    /// "A *= 2" and the like.
    void change(const assignment& a) {
        const auto before = known_.find(a.name);
        if (before == known_.end()) return;
        auto& x = out_.all[before->second];
        if (x.trouble.empty() && x.is == variable::kind::array && p_.related(x.scope, a.scope))
            x.trouble = "line " + std::to_string(a.line) + " changes it";
    }

    void find_unnamed() {
        std::size_t next = 0, covered = 0;
        std::vector<std::pair<std::size_t, std::size_t>> ranges = std::move(ranges_);
        for (std::size_t i = 0; i < p_.tokens.size(); ++i) {
            while (next < ranges.size() && ranges[next].first <= i)
                covered = std::max(covered, ranges[next++].second);
            if (i < covered || !brackets_.at(i)) continue;
            const auto close = p_.tokens[i].partner;
            const bool key = close + 1 < p_.tokens.size() && is_sign(p_.tokens[close + 1], ":");
            if (!key && (out_.unnamed.empty() || out_.unnamed.back() != p_.tokens[i].line))
                out_.unnamed.push_back(p_.tokens[i].line);
            i = p_.tokens[i].partner;
        }
    }

    const program& p_;
    number_brackets brackets_;
    std::vector<std::size_t> numbers_,
        statements_;  ///< how many brackets with numbers and statements before each token
    variables out_;
    std::map<std::string, std::size_t> known_;
    std::map<std::pair<std::size_t, std::string>, std::size_t> of_elements_;
    std::map<std::pair<std::size_t, std::string>, value> element_values_;
    const value zero_ = number_value("0", 0);
    std::vector<write> writes_;
    std::set<std::size_t> written_;                              ///< whose elements are assigned
    std::string assigned_;                                       ///< the name whose value is at work
    std::vector<std::pair<std::size_t, std::string>> pointers_;  ///< scopes and names
    std::vector<std::pair<std::size_t, std::size_t>> ranges_;
    std::vector<std::size_t> found_;  ///< names in the value at work
    std::size_t covered_from_ = 0, covered_ = 0, from_ = 1, scope_ = 0;
};

STAGECRAFT_INLINE variables variables_of(const program& p) { return variable_reader(p).run(); }

}  // namespace stagecraft::tableaux::program_text
