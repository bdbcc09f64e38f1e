// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_indexed.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/program_names.hpp"

namespace stagecraft::tableaux::program_text {

/// Whether a word for coefficients ends the stem, and is all of it or has a separator before it.
STAGECRAFT_INLINE bool ends_with_coefficient(std::string_view stem) {
    for (auto begin = stem.size(); begin-- > 0;)
        if ((begin == 0 || stem[begin - 1] == '_') && is_coefficient(stem.substr(begin))) return true;
    return false;
}

STAGECRAFT_INLINE std::optional<indexed_name> indexed(std::string_view name) {
    if (name.size() > longest_name) return std::nullopt;
    const auto last = name.find_last_not_of("0123456789_");
    if (last == name.npos || last + 1 == name.size()) return std::nullopt;
    indexed_name out{std::string(name.substr(0, last + 1)), {}};
    for (auto at = last + 1; at < name.size();) {
        const auto end = std::min(name.find('_', at), name.size());
        if (end > at) out.index.emplace_back(name.substr(at, end - at));
        at = end + 1;
    }
    const bool sized =
        std::all_of(out.index.begin(), out.index.end(), [](const auto& i) { return i.size() <= 4; });
    if (out.index.empty() || out.index.size() > 2 || !sized || !ends_with_coefficient(out.stem))
        return std::nullopt;
    return out;
}

/// Gathers one scope.
class gathering {
  public:
    explicit gathering(variables& v) : v_(v) {}

    void add(std::size_t k) {
        const auto& x = v_.all[k];
        if (x.is == variable::kind::array && !indexed(x.last())) arrays_.insert(x.name);
        const bool row = x.is == variable::kind::array && !x.array.nested && !x.array.reshaped;
        if (!row && x.is != variable::kind::number && x.is != variable::kind::other) return;
        auto name = indexed(x.last());
        if (!name) return;
        if (!names_.insert(x.name).second) {
            flush();
            names_.insert(x.name);
        }
        stems_[x.owner() + name->stem].push_back({k, std::move(name->index)});
    }

    void flush() {
        std::size_t from = 1;
        std::vector<std::pair<std::string, bool>> found;
        for (const auto& [stem, members] : stems_) {
            const auto kind = kind_of(stem, members);
            if (!kind) continue;
            found.emplace_back(stem, *kind);
            for (const auto& m : members)
                for (const auto i : places(m, *kind))
                    if (i == 0) from = 0;
        }
        for (const auto& [stem, matrix] : found) put(stem, stems_[stem], matrix, from);
        names_.clear();
        stems_.clear();
        arrays_.clear();
    }

  private:
    struct member {
        std::size_t variable;
        std::vector<std::string> index;
    };

    bool is_row(const member& m) const { return v_.all[m.variable].is == variable::kind::array; }

    /// Whether the members are a matrix; nothing where they are no array: one member, or an array of that very name.
    std::optional<bool> kind_of(const std::string& stem, const std::vector<member>& all) const {
        const bool rows = std::any_of(all.begin(), all.end(), [&](const auto& m) { return is_row(m); });
        if (all.size() < 2 && (rows || all.front().index.front().size() < 2)) return std::nullopt;
        const bool in_array =
            std::any_of(all.begin(), all.end(), [&](const auto& m) { return v_.all[m.variable].in_array; });
        if (arrays_.contains(stem) || in_array) return std::nullopt;
        if (rows) return true;
        // b1 beside b20 and b21 is b10, whose column is left out; beside b10 or b12 it is the first of a list.
        std::size_t singles = 0;
        bool lower = true;
        for (const auto& m : all) {
            const auto& i = m.index.front();
            singles += m.index.size() == 1 && i.size() == 1 ? 1 : 0;
            lower = lower && (i.size() == 1 ? i == "1" : i.size() > 2 || (i[1] < i[0] && i != "10"));
        }
        return singles == 0 || (singles == 1 && lower && all.size() > 2);
    }

    /// One place or two, as written.
    std::vector<std::size_t> places(const member& m, bool matrix) const {
        const auto& text = m.index.front();
        if (matrix && !is_row(m) && m.index.size() == 1 && text == "1") return {1, 0};
        if (!matrix || m.index.size() == 2 || is_row(m) || text.size() == 1) {
            std::vector<std::size_t> out;
            for (const auto& i : m.index) out.push_back(std::stoul(i));
            return out;
        }
        const auto cut = text.size() == 2 ? 1 : 2;
        return {std::stoul(text.substr(0, cut)), std::stoul(text.substr(cut))};
    }

    void put(const std::string& stem, const std::vector<member>& all, bool matrix, std::size_t from) {
        const auto& first = v_.all[all.front().variable];
        variable x;
        x.name = stem;
        x.scope = first.scope;
        x.line = first.line;
        x.last_line = v_.all[all.back().variable].last_line;
        x.is = variable::kind::array;
        x.array.is_array = x.by_elements = true;
        x.gathered_as = matrix ? variable::gathered::matrix : variable::gathered::list;
        for (const auto& m : all) {
            const auto& y = v_.all[m.variable];
            const auto at = places(m, matrix);
            const bool fits = at.size() == (matrix && !is_row(m) ? 2U : 1U) && at.front() >= from &&
                              at.front() < from + 64 && at.back() >= from && at.back() < from + 64;
            if (x.trouble.empty() && (!y.trouble.empty() || !fits))
                x.trouble =
                    y.name + " (line " + std::to_string(y.line) + "): " + (fits ? y.trouble : "its indices");
            x.members.push_back(m.variable);
            if (!x.trouble.empty()) continue;
            if (!is_row(m)) {
                x.elements.push_back({matrix ? at.front() - from : 0, at.back() - from, y.array.rows[0][0]});
                continue;
            }
            std::size_t column = 0;
            for (const auto& c : y.array.all()) x.elements.push_back({at.front() - from, column++, c});
            for (const auto& e : y.elements) x.elements.push_back({at.front() - from, e.column, e.number});
        }
        v_.all.push_back(std::move(x));
    }

    variables& v_;
    std::set<std::string> names_, arrays_;
    std::map<std::string, std::vector<member>> stems_;
};

STAGECRAFT_INLINE void gather_indexed(variables& v) {
    std::map<std::size_t, std::vector<std::size_t>> scopes;
    for (std::size_t k = 0; k < v.all.size(); ++k) scopes[v.all[k].scope].push_back(k);
    for (const auto& [scope, all] : scopes) {
        gathering g(v);
        for (const auto k : all) g.add(k);
        g.flush();
    }
}

}  // namespace stagecraft::tableaux::program_text
