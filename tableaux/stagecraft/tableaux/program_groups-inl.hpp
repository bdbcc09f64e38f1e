// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_groups.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/claims.hpp"
#include "stagecraft/tableaux/program_dense.hpp"
#include "stagecraft/tableaux/program_leftovers.hpp"
#include "stagecraft/tableaux/program_names.hpp"

namespace stagecraft::tableaux::program_text {

void take_dense(groups& out, variables& v);  // of program_dense.hpp, which includes this

/// Puts variables together.
class grouping {
  public:
    grouping(const program& p, variables& v) : p_(p), v_(v) {}

    groups run() && {
        add_missing_matrices();
        std::map<std::size_t, std::vector<std::size_t>> scopes;
        for (std::size_t k = 0; k < v_.all.size(); ++k) scopes[v_.all[k].scope].push_back(k);
        for (std::size_t k = 0; k < v_.all.size(); ++k)
            if (is_array(k)) by_name_[at(k).name].push_back(k);
        for (const auto& r : p_.registrations) take_registration(r);
        for (std::size_t g = 0; g < out_.all.size(); ++g) take_rest(out_.all[g], scopes[out_.all[g].scope]);
        for (const auto& [scope, all] : scopes)
            for (const auto& run : runs_of(all)) group_run(run);
        join_scattered();
        for (std::size_t g = 0; g < out_.all.size();
             ++g) {  // each scope has its groups, or else those within it
            auto scope = out_.all[g].scope;
            in_scope_[scope].push_back(g);
            for (int i = 0; i < deepest_scope && p_.scopes[scope].parent != nowhere; ++i)
                inner_[scope = p_.scopes[scope].parent].push_back(g);
        }
        within_scope_ = in_scope_;
        within_scope_.merge(inner_);
        for (std::size_t k = 0; k < v_.all.size(); ++k) give_claim(k);
        std::stable_sort(out_.all.begin(), out_.all.end(),
                         [](const group& x, const group& y) { return x.line < y.line; });
        take_dense(out_, v_);
        leftovers(v_, taken_, out_).tell();
        return std::move(out_);
    }

  private:
    /// "B->b[0] = 1" alone: Euler's method, whose A is 0.
    void add_missing_matrices() {
        for (std::size_t k = 0; k < v_.all.size(); ++k) {
            const auto b = v_.all[k];
            const bool one = b.elements.size() == 1 && b.elements[0].row == 0 && b.elements[0].column == 0;
            if (b.last() != "b" || !b.owner().ends_with("->") || !one || !b.by_elements) continue;
            const auto is_matrix = [&](const auto& a) {
                return a.scope == b.scope && a.name == b.owner() + "A";
            };
            if (std::any_of(v_.all.begin(), v_.all.end(), is_matrix)) continue;
            variable a;
            a.name = b.owner() + "A";
            a.scope = b.scope;
            a.line = a.last_line = b.line;
            a.is = variable::kind::array;
            a.array = {true, true, false, false, {{{"0", b.line}}}};
            v_.all.push_back(std::move(a));
        }
    }

    /// What a call does not name: keyword arguments as Julia's αEEst.
    void take_rest(group& g, const std::vector<std::size_t>& all) {
        std::map<std::string, std::size_t> names;
        for (const auto k : all)
            if (is_array(k)) names.emplace(at(k).name, k);
        for (const auto& d : dialects) take_more(g, d, names, false);
    }

    using part = std::vector<std::size_t>;  ///< variables
    const variable& at(std::size_t k) const { return v_.all[k]; }
    bool is_array(std::size_t k) const { return at(k).is == variable::kind::array; }

    /// Parts in which no name comes twice. A claim right before the array that begins the next part belongs to it.
    std::vector<part> runs_of(const part& all) const {
        std::vector<part> runs(1);
        std::set<std::string> names;
        std::map<std::string, std::size_t> later;  // how often each array's name is still to come
        for (const auto k : all)
            if (is_array(k)) ++later[at(k).name];
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto& x = at(all[i]);
            if (is_array(all[i])) --later[x.name];
            bool next = names.contains(x.name);
            if (!next && !is_array(all[i]) && claim_in(x.name) && i > 0 && i + 1 < all.size() &&
                at(all[i + 1]).line - x.last_line < x.line - at(all[i - 1]).last_line) {
                auto array = i + 1;
                while (array + 1 < std::min(all.size(), i + 8) && !is_array(all[array])) ++array;
                next = names.contains(at(all[array]).name);
            }
            if (next) {
                runs.emplace_back();
                names.clear();
            }
            names.insert(x.name);
            runs.back().push_back(all[i]);
        }
        return runs;
    }

    /// The unused array of this name in a run.
    std::optional<std::size_t> named(const part& r, const std::string& name) const {
        for (const auto k : r)
            if (is_array(k) && !taken_.contains(k) && at(k).name == name) return k;
        return std::nullopt;
    }

    void group_run(const part& r) {
        std::map<std::string, std::size_t> names;
        for (const auto k : r)
            if (is_array(k)) names.emplace(at(k).name, k);
        std::vector<std::pair<std::size_t, const dialect*>> found;  // group and the dialect that it speaks
        for (const auto& d : dialects)
            for (const auto k : r)
                if (is_array(k) && !taken_.contains(k))
                    if (begin_group(k, d, names)) found.emplace_back(out_.all.size() - 1, &d);
        for (const auto& [g, d] : found) take_more(out_.all[g], *d, names, found.size() == 1);
        for (const auto& [g, d] : found)
            for (const auto k : r) take_claim(out_.all[g], k, false);
        if (found.size() == 1)
            for (const auto k : r) take_claim(out_.all[found.front().first], k, true);
    }

    /// A group with the array k as A, if b stands beside it under a name of the same kind.
    bool begin_group(std::size_t k, const dialect& d, const std::map<std::string, std::size_t>& names) {
        const auto& x = at(k);
        const std::string owner = x.owner(), last(x.last());
        if (last.size() > longest_name || x.gathered_as == variable::gathered::list) return false;
        if (d.nested && !x.array.nested && !x.array.reshaped && x.elements.empty()) return false;
        if (x.gathered_as == variable::gathered::matrix && has_diagonal(x)) return false;
        for (const auto a : words_of(d.A))
            for (auto i = last.find(a); i != last.npos; i = last.find(a, i + 1)) {
                const std::string before = last.substr(0, i), behind = last.substr(i + a.size());
                if (d.needs_embedded && !has_word(d.embedded, names, owner + before, behind)) continue;
                for (const auto b : words_of(d.b)) {
                    const auto y = names.find(owner + before + std::string(b) + behind);
                    if (y == names.end() || y->second == k || !is_list(y->second)) continue;
                    add_group(k, y->second, d, before, behind);
                    return true;
                }
                const bool last_row = d.b.empty() && before.empty() && behind.empty() &&
                                      !names.contains("b") && x.elements.empty() && !x.array.rows.empty();
                if (!last_row && !ends_with_solution(k, d, names, before, behind)) continue;
                add_group(k, nowhere, d, before, behind);
                if (last_row) out_.all.back().last_row_of = k;
                return true;
            }
        return false;
    }
    static bool has_word(std::string_view words, const std::map<std::string, std::size_t>& names,
                         const std::string& before, const std::string& behind) {
        const auto all = words_of(words);
        return std::any_of(all.begin(), all.end(),
                           [&](auto w) { return names.contains(before + std::string(w) + behind); });
    }

    /// Not used, and no matrix of single coefficients.
    bool is_list(std::size_t k) const {
        const auto& rows = at(k).array.rows;
        return !taken_.contains(k) && at(k).gathered_as != variable::gathered::matrix &&
               (!at(k).array.nested || rows.size() < 3 || rows.size() == at(k).array.numbers());
    }

    bool has_diagonal(const variable& x) const {
        return std::any_of(v_.all.begin(), v_.all.end(), [&](const auto& y) {
            return y.scope == x.scope && y.is == variable::kind::number && is_diagonal_word(y.last());
        });
    }

    /// b is nothing, or the last row of A.
    void add_group(std::size_t k, std::size_t b, const dialect& d, const std::string& before,
                   const std::string& behind) {
        const auto& x = at(k);
        const auto line = b == nowhere ? x.line : std::min(x.line, at(b).line);
        group g{{}, x.scope, line, {{"A", k}}, nlohmann::json::object(), before, behind};
        if (b != nowhere) g.arrays["b"] = b;
        g.embedded_from = d.embedded_from;
        g.name = name_of(g, x.owner());
        use(k);
        if (b != nowhere) use(b);
        out_.all.push_back(std::move(g));
    }

    /// Where the last stage is the solution (first same as last), single coefficients, or the rows of A from its second on,
    /// need no b where the weights of the error stand beside them.
    bool ends_with_solution(std::size_t k, const dialect& d, const std::map<std::string, std::size_t>& names,
                            const std::string& before, const std::string& behind) const {
        const auto& x = at(k);
        const auto& rows = x.array.rows;
        const bool single = x.gathered_as == variable::gathered::matrix;
        const bool rows_from_second =
            x.array.nested && !rows.empty() && rows.front().size() == 1 && rows.back().size() == rows.size();
        if (!single && !rows_from_second) return false;
        for (const auto e : words_of(d.embedded)) {
            const auto y = names.find(x.owner() + before + std::string(e) + behind);
            if (y == names.end() || !is_list(y->second)) continue;
            if (single && at(y->second).gathered_as != variable::gathered::no) return true;
            if (rows_from_second && at(y->second).array.numbers() == rows.size() + 1) return true;
        }
        return false;
    }

    void use(std::size_t k) {
        v_.all[k].used = true;
        taken_.insert(k);
        for (const auto m : at(k).members) use(m);
    }

    std::string name_of(const group& g, std::string owner) const {
        const bool arrow = owner.ends_with("->");
        owner.erase(owner.find_last_not_of(".:->") + 1);
        if (arrow || owner == "self" || owner == "this" || owner == "cls" || owner == "obj") owner.clear();
        std::string name = g.before + (g.before.empty() ? "" : " ") + g.behind;
        const auto blank = [](char ch) { return ch == '_' || ch == ' '; };
        name.erase(name.begin(), std::find_if_not(name.begin(), name.end(), blank));
        while (!name.empty() && blank(name.back())) name.pop_back();
        if (owner.empty()) owner = p_.name_of(g.scope);
        if (!name.empty() &&
            std::all_of(name.begin(), name.end(), [](unsigned char ch) { return std::isdigit(ch); }))
            name = at(g.arrays.at("A")).last();  // A1
        return owner.empty() || name.empty() ? owner + name : owner + " " + name;
    }

    /// c, the embedded weights and the diagonal; by their bare words too where the run has one tableau.
    void take_more(group& g, const dialect& d, const std::map<std::string, std::size_t>& names, bool only) {
        const auto& a = at(g.arrays.at("A"));
        const auto take = [&](const char* key, std::string_view words) {
            for (const bool bare : {false, true})
                for (const auto word : words_of(words)) {
                    if (g.arrays.contains(key) || (bare && !only)) return;
                    const auto name =
                        a.owner() + (bare ? std::string(word) : g.before + std::string(word) + g.behind);
                    const auto y = names.find(name);
                    if (y == names.end() || taken_.contains(y->second) || !fits(g, y->second, word)) continue;
                    g.arrays[key] = y->second;
                    use(y->second);
                }
        };
        take("c", d.c);
        take("b_embedded", d.embedded);
        take("diagonal", d.diagonal);
    }

    /// E, e and d have other meanings too: they must be as long as b, or longer by one.
    bool fits(const group& g, std::size_t k, std::string_view word) const {
        if (at(k).gathered_as == variable::gathered::matrix) return false;
        if (!g.arrays.contains("b")) {
            const bool one_more = at(k).array.numbers() == at(g.arrays.at("A")).array.rows.size() + 1;
            return at(k).trouble.empty() && (word.size() > 1 || !at(k).members.empty() || one_more);
        }
        const auto& b = at(g.arrays.at("b"));
        if (!at(k).trouble.empty()) return false;
        if (word.size() > 1 || word == "c" || word == "C" || !at(k).elements.empty() || !b.elements.empty())
            return true;
        const auto s = b.array.numbers(), n = at(k).array.numbers();
        return n == s || n == s + 1;
    }

    /// The value of a claim, or nothing: a whole number, true or false, a text.
    static std::optional<nlohmann::json> claimed(const std::string& key, const variable& x) {
        const bool counted = std::any_of(counted_claims.begin(), counted_claims.end(),
                                         [&](const auto& c) { return c.name == key; });
        if (key == "name")
            return x.is == variable::kind::text ? std::optional<nlohmann::json>(x.text) : std::nullopt;
        if (!counted && x.is == variable::kind::flag) return x.text == "true";
        if (x.is != variable::kind::number) return std::nullopt;
        const std::string& number = x.array.rows[0][0].text;
        if (number.empty() || number.size() > 3 || number.find_first_not_of("0123456789") != number.npos)
            return std::nullopt;
        if (counted) return std::stoi(number);
        return number == "0" || number == "1" ? std::optional<nlohmann::json>(number == "1") : std::nullopt;
    }

    /// `bare`: the word alone, not with what stands beside A in its name.
    bool take_claim(group& g, std::size_t k, bool bare) {
        const auto name = claim_in(at(k).name);
        if (!name || taken_.contains(k) || is_array(k)) return false;
        const bool alike = bare ? name->behind.empty() && (name->before.empty() || at(k).returned)
                                : name->before == lower(g.before) && name->behind == lower(g.behind);
        const auto value = claimed(name->key, at(k));
        if (!alike || !value) return false;
        auto& claims = g.claims;
        if (claims.contains(name->key)) return false;
        claims[name->key] = *value;
        use(k);
        return true;
    }

    /// A call that says which arrays are a tableau, and its name and order.
    void take_registration(const registration& r) {
        std::vector<std::size_t> arguments{r.open + 1};
        bool declaration = false;
        for (auto i = r.open + 1; i < p_.tokens[r.open].partner; ++i) {
            const token& t = p_.tokens[i];
            if (is_open(t) && t.partner != nowhere) i = t.partner;
            if (is_sign(t, ",")) arguments.push_back(i + 1);
            declaration =
                declaration || (t.is == token::kind::word && p_.tokens[i + 1].is == token::kind::word);
        }
        for (auto& i : arguments)
            while (i + 1 < p_.tokens.size() && p_.tokens[i].is == token::kind::line_end) ++i;
        bool found = false;
        for (const auto& call : register_calls)
            if (!declaration && call.function == r.name) found = take_call(r, call, arguments) || found;
        const auto call = std::find_if(register_calls.begin(), register_calls.end(),
                                       [&](const auto& c) { return c.function == r.name; });
        const bool handed_on = call != register_calls.end() && call->order < arguments.size() &&
                               p_.tokens[arguments[call->order]].is == token::kind::word;
        if (!found && !declaration && !handed_on)  // by a function with the same arguments
            out_.unused.emplace(r.line,
                                r.name + " (line " + std::to_string(r.line) + "): its arrays are not found");
    }

    bool take_call(const registration& r, const register_call& call,
                   const std::vector<std::size_t>& arguments) {
        const auto word = [&](std::size_t index) {
            if (index >= arguments.size()) return std::string();
            const auto at = arguments[index];
            return p_.tokens[is_sign(p_.tokens[at], "&") ? at + 1 : at].text;
        };
        const auto A = array_before(r, word(call.A)), b = array_before(r, word(call.b));
        const auto row = array_before(r, word(call.last_row_of));
        if (!A || (!b && !row)) return false;
        group g{{}, at(*A).scope, at(*A).line, {{"A", *A}}, nlohmann::json::object(), {}, {}};
        if (b) g.arrays["b"] = *b;
        if (!b) g.last_row_of = *row;
        if (const auto c = array_before(r, word(call.c))) g.arrays["c"] = *c;
        if (const auto e = array_before(r, word(call.embedded))) g.arrays["b_embedded"] = *e;
        for (const auto index : {call.dense, call.or_dense})
            if (const auto d = array_before(r, word(index)); d && !g.arrays.contains("b_theta"))
                g.arrays["b_theta"] = *d;
        for (const auto& [key, k] : g.arrays) use(k);
        g.name = name_of(g, at(*A).owner());
        if (const auto name = word(call.name); !name.empty())
            g.claims["name"] = name + std::string(call.part);
        const auto order = word(call.order);
        if (!order.empty() && order.size() < 3 && order.find_first_not_of("0123456789") == order.npos)
            g.claims["order"] = std::stoi(order);
        else
            out_.unused.emplace(r.line,
                                r.name + " (line " + std::to_string(r.line) + "): its order is no number");
        out_.all.push_back(std::move(g));
        return true;
    }

    /// The last array of this name before a call, in its scope or one around it.
    std::optional<std::size_t> array_before(const registration& r, const std::string& name) const {
        const auto named = by_name_.find(name);
        if (named == by_name_.end()) return std::nullopt;
        for (auto k = named->second.rbegin(); k != named->second.rend(); ++k)
            if (at(*k).line <= r.line && at(*k).gathered_as == variable::gathered::no)
                return p_.related(at(*k).scope, r.scope) ? std::optional(*k) : std::nullopt;
        return std::nullopt;
    }

    /// A and b of the only tableau may stand in different functions or brackets.
    void join_scattered() {
        if (!out_.all.empty()) return;
        std::map<std::string, std::size_t> count;
        part r;
        for (std::size_t k = 0; k < v_.all.size(); ++k)
            if (is_array(k) && ++count[at(k).name] == 1) r.push_back(k);
        for (const auto& [name, n] : count)
            if (n > 1 && name.size() <= 2) return;
        group_run(r);
    }

    /// What stands in no run of a tableau, to the one in the nearest scope around it or to the only one within its scope.
    void give_claim(std::size_t k) {
        const auto& x = at(k);
        const auto name = claim_in(x.name);
        const bool prefixed = name && !name->before.empty() && !(x.returned && out_.all.size() == 1);
        if (taken_.contains(k) || is_array(k) || !name || prefixed || !name->behind.empty()) return;
        auto scope = x.scope;
        for (int i = 0; i < deepest_scope && scope != nowhere; ++i, scope = p_.scopes[scope].parent) {
            const bool only = out_.all.size() == 1 && p_.scopes[scope].parent == nowhere;
            const auto& groups_here = i == 0 || only ? within_scope_ : in_scope_;
            const auto here = groups_here.find(scope);
            if (here == groups_here.end()) continue;
            if (here->second.size() == 1) take_claim(out_.all[here->second.front()], k, true);
            return;
        }
    }

    const program& p_;
    variables& v_;
    groups out_;
    std::set<std::size_t> taken_;
    std::map<std::string, std::vector<std::size_t>> by_name_;
    std::map<std::size_t, std::vector<std::size_t>> in_scope_, inner_, within_scope_;  ///< groups by scopes
};

STAGECRAFT_INLINE groups groups_of(const program& p, variables& v) { return grouping(p, v).run(); }

}  // namespace stagecraft::tableaux::program_text
