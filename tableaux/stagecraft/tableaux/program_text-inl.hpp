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
#include "stagecraft/tableaux/program_dense.hpp"
#include "stagecraft/tableaux/program_groups.hpp"
#include "stagecraft/tableaux/program_indexed.hpp"
#include "stagecraft/tableaux/program_scan.hpp"
#include "stagecraft/tableaux/program_variables.hpp"
#include "stagecraft/tableaux/read.hpp"

namespace stagecraft::tableaux {

namespace program_text {

using cells = std::vector<cell>;

/// How many stages single elements need.
STAGECRAFT_INLINE std::size_t stages_of_elements(const variable& x) {
    std::size_t s = 0;
    for (const auto& e : x.elements) s = std::max({s, e.row + 1, e.column + 1});
    return s;
}

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
    const bool from_second = a.gathered_as != variable::gathered::no && stages_of_elements(a) + 1 == s;
    for (auto& row : rows)
        if (row.size() < rows.size()) row.resize(rows.size(), {"0", a.line});
    for (const auto& e : a.elements) {
        const auto row = e.row + (from_second ? 1 : 0);
        if (row < rows.size() && e.column < rows[row].size()) rows[row][e.column] = e.number;
    }
    return rows;
}

/// A node that is not given.
inline constexpr const char* unknown = "?";

/// At least s numbers where some are given one by one, the others as `missing`.
STAGECRAFT_INLINE cells list_of(const variable& x, std::size_t s, const char* missing) {
    cells all = x.array.all();
    s = std::max(s, stages_of_elements(x));
    if (!x.elements.empty() || all.empty()) all.resize(std::max(all.size(), s), {missing, x.line});
    for (const auto& e : x.elements)
        if (e.row == 0 && e.column < all.size()) all[e.column] = e.number;
    return all;
}

/// The tableau of a group, cell by cell.
struct parts {
    std::vector<cells> A;
    cells b, c, embedded;
    std::vector<cells> dense;    ///< a row for each stage
    bool two_registers = false;  ///< A and b are the lists of a low-storage form
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

STAGECRAFT_INLINE bool is_zero(const cell& c) { return read_entry(c.text).enclosure.middle() == rational(0); }

/// What programs that name each coefficient leave out: nodes that are 0 or are not needed, which are the sums of their
/// rows; a21, which is c2; weights that are 0.
STAGECRAFT_INLINE void complete(parts& t) {
    const auto s = t.b.size();
    const auto line = t.b.front().line;
    if (!t.embedded.empty() && t.embedded.size() < s) t.embedded.resize(s, {"0", line});
    const bool is_explicit = !t.A.empty() && std::all_of(t.A[0].begin(), t.A[0].end(), is_zero);
    const bool from_second = t.c.size() < s && is_explicit && !t.c.empty() && t.c.front().text != unknown;
    if (from_second && !is_zero(t.c.front())) t.c.insert(t.c.begin(), {"0", line});
    if (is_explicit && t.c.size() > 1 && s > 1 && std::all_of(t.A[1].begin(), t.A[1].end(), is_zero))
        t.A[1][0] = t.c[1];
    if (t.c.empty()) return;
    t.c.resize(std::max(s, t.c.size()), {unknown, line});
    for (std::size_t i = 0; i < s; ++i) {
        if (t.c[i].text != unknown) continue;
        std::string sum;
        for (const auto& x : t.A[i])
            if (x.text != "0") sum += (sum.empty() ? "(" : "+(") + x.text + ")";
        t.c[i].text = sum.empty() ? "0" : bounded(sum);
    }
}

/// Two sets of weights in one array, b first.
STAGECRAFT_INLINE void split_weights(const value& b, const value& a, parts& t) {
    const auto n = b.numbers() / 2;
    const bool rows = b.rows.size() == 2 && b.rows[0].size() == n && b.rows[1].size() == n && n > 1;
    const bool columns = b.reshaped && b.by_columns && b.numbers() == 2 * n && a.numbers() == n * n && n > 0;
    if (!rows && !columns) return;
    const auto all = b.all();
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(n);
    t.b.assign(all.begin(), middle);
    t.embedded.assign(middle, all.end());
}

/// Programs that store by columns may keep A^T, so that a stage's numbers lie together: where nothing but zeros stands on
/// and below the diagonal, no method is meant as it stands.
STAGECRAFT_INLINE void turn(std::vector<cells>& A) {
    for (std::size_t i = 0; i < A.size(); ++i)
        for (std::size_t j = 0; j <= i && j < A[i].size(); ++j)
            if (!is_zero(A[i][j])) return;
    for (std::size_t i = 0; i < A.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (i < A[j].size()) std::swap(A[i][j], A[j][i]);
}

/// The rows of an explicit method from its second stage on, at last b: the nodes begin with 0, the rows do not.
STAGECRAFT_INLINE void drop_last_row(parts& t) {
    const bool from_second = !t.c.empty() && is_zero(t.c.front()) && !t.A.empty() && !t.A[0].empty() &&
                             !is_zero(t.A[0][0]) && t.A.size() == t.b.size();
    if (!from_second) return;
    t.A.pop_back();
    t.A.insert(t.A.begin(), cells(t.b.size(), {"0", t.b.front().line}));
}

/// Williamson's A and B, two lists of which the first begins with 0, as no packed triangle of a method does.
STAGECRAFT_INLINE bool is_low_storage(const variable& a, const cells& b) {
    const auto all = a.array.all();
    return !a.array.nested && !a.array.reshaped && a.elements.empty() && b.size() > 2 &&
           all.size() == b.size() && is_zero(all.front());
}

/// Where none of them is negative the program subtracts them: the method has them negative.
STAGECRAFT_INLINE void with_the_sign_of_the_method(cells& A) {
    const auto negative = [](const cell& x) { return read_entry(x.text).enclosure.middle() < rational(0); };
    if (std::any_of(A.begin(), A.end(), negative)) return;
    for (auto& x : A)
        if (!is_zero(x)) x.text = "-(" + x.text + ")";
}

STAGECRAFT_INLINE parts parts_of(const group& g, const variables& v) {
    std::size_t s =
        0;  // not by names with indices that are left out where they are 0, or one behind the last stage
    for (const auto& [key, k] : g.arrays)
        if (key == "A" || key == "b" || v.all[k].gathered_as == variable::gathered::no)
            s = std::max(s, stages_of_elements(v.all[k]));
    parts t;
    const auto list = [&](const char* key) {
        const auto at = g.arrays.find(key);
        if (at == g.arrays.end()) return cells{};
        const auto& x = v.all[at->second];
        return list_of(
            x, x.gathered_as == variable::gathered::no || key == std::string_view("b") ? s : 0,
            key == std::string_view("c") && x.gathered_as != variable::gathered::no ? unknown : "0");
    };
    t.b = list("b");
    if (g.last_row_of != nowhere && !v.all[g.last_row_of].array.rows.empty())
        t.b = v.all[g.last_row_of].array.rows.back();
    t.c = list("c");
    t.embedded = list("b_embedded");
    const auto& a = v.all[g.arrays.at("A")];
    if (t.embedded.empty() && g.arrays.contains("b"))
        split_weights(v.all[g.arrays.at("b")].array, a.array, t);
    t.embedded.erase(t.embedded.begin(), t.embedded.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                  g.embedded_from, t.embedded.size())));
    if (is_low_storage(a, t.b)) {
        t.A = {a.array.all()};
        t.two_registers = true;
        return t;
    }
    if (t.b.empty() && a.array.nested) s = t.embedded.size();
    t.A = matrix_of(a, std::max(t.b.size(), s));
    if (a.array.reshaped && a.array.by_columns) turn(t.A);
    if (g.last_row_of == g.arrays.at("A")) drop_last_row(t);
    if (t.b.empty() && !t.A.empty()) t.b = t.A.back();  // that of the solution
    const cells diagonal = list("diagonal");
    for (std::size_t i = 0; i < std::min(diagonal.size(), t.A.size()); ++i)
        if (i < t.A[i].size()) t.A[i][i] = diagonal[i];
    if (t.c.size() + 1 == t.b.size() && !t.c.empty() && t.c.front().text != "0" &&
        t.c.front().text != unknown)
        t.c.insert(t.c.begin(), {"0", t.c.front().line});
    if (a.gathered_as != variable::gathered::no) complete(t);
    t.dense = dense_of(g, v, t.b);
    const auto all_stages = std::max(t.embedded.size(), t.dense.size());
    if (all_stages == t.b.size() + 1 && t.A.size() == t.b.size()) add_last_stage(t);
    if (t.dense.size() + 1 == t.b.size() && !t.dense.empty()) t.dense.push_back({{"0", t.b.back().line}});
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
        if (const auto& x = v.all[g.arrays.contains(key)     ? g.arrays.at(key)
                                  : g.last_row_of != nowhere ? g.last_row_of
                                                             : g.arrays.at("A")];
            !x.trouble.empty())
            throw unusable_input("line " + std::to_string(x.line) + ", " + x.name + ": " + x.trouble);
    parts t;
    try {
        t = parts_of(g, v);
        nlohmann::json j{
            {"name", g.name}, {"A", nlohmann::json::array()}, {t.two_registers ? "B" : "b", texts(t.b)}};
        if (t.two_registers) with_the_sign_of_the_method(t.A.front());
        for (const auto& row : t.A) j["A"].push_back(texts(row));
        if (t.two_registers) {
            j["form"] = "2N";
            j["A"] = texts(t.A.front());
        }
        if (!t.c.empty()) j["c"] = texts(t.c);
        if (!t.embedded.empty()) j["b_embedded"] = texts(t.embedded);
        for (const auto& row : t.dense) j["b_theta"].push_back(texts(row));
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
    text::gather_indexed(variables);
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
