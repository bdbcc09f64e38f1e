// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_text.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/entry.hpp"
#include "stagecraft/tableaux/program_groups.hpp"
#include "stagecraft/tableaux/program_scan.hpp"
#include "stagecraft/tableaux/program_variables.hpp"
#include "stagecraft/tableaux/read.hpp"

namespace stagecraft::tableaux {

namespace program_text {

using cells = std::vector<cell>;

/// The rows of A with s stages: a full matrix, a packed triangle, rows of different lengths, or single elements.
STAGECRAFT_INLINE std::vector<cells> matrix_of(const variable& a, std::size_t s) {
    auto rows = a.array.rows;
    const auto all = a.array.all();
    const auto n = all.size();
    const bool flat = rows.size() == 1 || a.array.reshaped;
    if (s > 1 && flat && (n == s * s || n == s * (s - 1) / 2 || n == s * (s + 1) / 2)) {
        rows.assign(s, {});
        const std::size_t diagonal = n == s * (s + 1) / 2 ? 1 : 0;
        for (std::size_t i = 0, k = 0; i < s; ++i)
            for (std::size_t j = 0; n == s * s ? j < s : j < i + diagonal; ++j, ++k)
                rows[i].push_back(all[n == s * s && a.array.by_columns ? j * s + i : k]);
    }
    if (!a.elements.empty() || n == 0) rows.resize(std::max(rows.size(), s));
    if (rows.size() + 1 == s) rows.insert(rows.begin(), cells{});  // no first row
    for (auto& row : rows)
        if (row.size() < rows.size()) row.resize(rows.size(), {"0", a.line});
    for (const auto& e : a.elements)
        if (e.row < rows.size() && e.column < rows[e.row].size()) rows[e.row][e.column] = e.number;
    return rows;
}

STAGECRAFT_INLINE cells list_of(const variable& x, std::size_t s) {
    cells all = x.array.all();
    if (!x.elements.empty() || all.empty()) all.resize(std::max(all.size(), s), {"0", x.line});
    for (const auto& e : x.elements)
        if (e.row == 0 && e.column < all.size()) all[e.column] = e.number;
    return all;
}

/// How many stages single elements need.
STAGECRAFT_INLINE std::size_t stages_of_elements(const variable& x) {
    std::size_t s = 0;
    for (const auto& e : x.elements) s = std::max({s, e.row + 1, e.column + 1});
    return s;
}

/// The tableau of a group, cell by cell.
struct parts {
    std::vector<cells> A;
    cells b, c, embedded;
};

STAGECRAFT_INLINE rational sum_of(const cells& all) {
    rational sum(0);
    for (const auto& x : all) sum += read_entry(x.text).enclosure.middle();
    return sum;
}

/// Embedded weights for one stage more are those of a method whose last stage is the solution (first same as last).
STAGECRAFT_INLINE void add_last_stage(parts& t) {
    const std::size_t s = t.b.size();
    for (auto& row : t.A) row.push_back({"0", t.b.front().line});
    t.A.push_back(t.b);
    t.A.back().push_back({"0", t.b.front().line});
    if (t.c.size() == s) t.c.push_back({"1", t.c.back().line});
    t.b.push_back({"0", t.b.front().line});
}

STAGECRAFT_INLINE parts parts_of(const group& g, const variables& v) {
    std::size_t s = 0;
    for (const auto& [key, k] : g.arrays) s = std::max(s, stages_of_elements(v.all[k]));
    parts t;
    const auto list = [&](const char* key) {
        const auto at = g.arrays.find(key);
        return at == g.arrays.end() ? cells{} : list_of(v.all[at->second], s);
    };
    t.b = list("b");
    if (g.last_row_of != nowhere && !v.all[g.last_row_of].array.rows.empty())
        t.b = v.all[g.last_row_of].array.rows.back();
    t.c = list("c");
    t.embedded = list("b_embedded");
    t.A = matrix_of(v.all[g.arrays.at("A")], t.b.size());
    const cells diagonal = list("diagonal");
    for (std::size_t i = 0; i < std::min(diagonal.size(), t.A.size()); ++i)
        if (i < t.A[i].size()) t.A[i][i] = diagonal[i];
    if (t.c.size() + 1 == t.b.size() && !t.c.empty()) t.c.insert(t.c.begin(), {"0", t.c.front().line});
    if (t.embedded.size() == t.b.size() + 1 && t.A.size() == t.b.size()) add_last_stage(t);
    if (t.embedded.size() == t.b.size() &&
        abs(sum_of(t.embedded)) < rational(1, 2))  // the difference of both
        for (std::size_t i = 0; i < t.b.size(); ++i)
            t.embedded[i].text = "(" + t.b[i].text + ")-(" + t.embedded[i].text + ")";
    return t;
}

/// The line of what a message names, as "A[2][1]" or "b".
STAGECRAFT_INLINE std::size_t line_of(const std::string& entry, const parts& t, std::size_t otherwise) {
    std::vector<std::size_t> index;
    for (auto at = entry.find('['); at != entry.npos && at + 1 < entry.size() && index.size() < 2;
         at = entry.find('[', at + 1))
        index.push_back(static_cast<std::size_t>(std::atoi(entry.c_str() + at + 1)) - 1);
    const auto name = entry.substr(0, entry.find('['));
    const cells* row = name == "b" ? &t.b : name == "c" ? &t.c : name == "b_embedded" ? &t.embedded : nullptr;
    if (name == "A" && !index.empty() && index[0] < t.A.size()) row = &t.A[index[0]];
    if (!row || row->empty()) return otherwise;
    const auto k = index.empty() ? 0 : index.back();
    return k < row->size() ? (*row)[k].line : row->front().line;
}

STAGECRAFT_INLINE nlohmann::json texts(const cells& all) {
    auto list = nlohmann::json::array();
    for (const auto& x : all) list.push_back(x.text);
    return list;
}

/// Throws unusable_input with the line.
STAGECRAFT_INLINE tableau_file file_of(const group& g, const variables& v, const reading& how) {
    for (const char* key : {"A", "b"})
        if (const auto& x = v.all[g.arrays.contains(key) ? g.arrays.at(key) : g.last_row_of];
            !x.trouble.empty())
            throw unusable_input("line " + std::to_string(x.line) + ", " + x.name + ": " + x.trouble);
    parts t;
    try {
        t = parts_of(g, v);
        nlohmann::json j{{"name", g.name}, {"A", nlohmann::json::array()}, {"b", texts(t.b)}};
        for (const auto& row : t.A) j["A"].push_back(texts(row));
        if (!t.c.empty()) j["c"] = texts(t.c);
        if (!t.embedded.empty()) j["b_embedded"] = texts(t.embedded);
        for (const auto& [key, value] : g.claims.items()) (key == "name" ? j : j["claims"])[key] = value;
        return read_tableau(j.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), how);
    } catch (const std::invalid_argument& e) {
        std::string what = e.what();
        if (what.starts_with("line 1, ")) what.erase(0, 8);
        const auto entry = what.substr(0, std::min(what.find_first_of(":. "), what.size()));
        throw unusable_input("line " + std::to_string(line_of(entry, t, g.line)) + ", " + what);
    }
}

/// Why a program has no tableau: what is there of one.
STAGECRAFT_INLINE std::string nothing_found(const groups& found) {
    std::string what = "no tableau: no arrays A and b that belong together";
    int told = 0;
    for (const auto& [line, text] : found.unused)
        if (told++ < 5) what += (told == 1 ? "; " : ", ") + text;
    return what;
}

}  // namespace program_text

STAGECRAFT_INLINE program_tableaux read_program_text(std::string_view source, const reading& how) {
    namespace text = program_text;
    program_tableaux out;
    const auto program = text::scan(source);
    text::variables variables;
    try {
        variables = text::variables_of(program);
    } catch (const std::invalid_argument& e) {
        throw unusable_input(e.what());
    }
    auto found = text::groups_of(program, variables);
    if (found.all.empty()) throw unusable_input(text::nothing_found(found));
    for (auto& g : found.all) {
        if (g.claims.contains("name")) g.name = g.claims["name"].get<std::string>();
        if (!g.arrays.contains("b_embedded") && g.claims.contains("embedded_order")) {
            if (g.claims["embedded_order"] != 0)
                found.unused.emplace(g.line, "embedded order of " +
                                                 (g.name.empty() ? "the tableau" : g.name) + " (line " +
                                                 std::to_string(g.line) + "): no embedded weights");
            g.claims.erase("embedded_order");
        }
        if (g.name.empty() && found.all.size() > 1) g.name = "line " + std::to_string(g.line);
        try {
            out.tableaux.push_back(text::file_of(g, variables, how));
        } catch (const unusable_input& e) {
            out.unusable.push_back({g.name, e.what()});
        }
    }
    for (auto& [line, what] : found.unused) out.unused.push_back(std::move(what));
    return out;
}

}  // namespace stagecraft::tableaux
