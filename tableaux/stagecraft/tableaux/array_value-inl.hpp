// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/array_value.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::tableaux::program_text {

STAGECRAFT_INLINE std::size_t value::numbers() const {
    std::size_t n = 0;
    for (const auto& row : rows) n += row.size();
    return n;
}

STAGECRAFT_INLINE std::vector<cell> value::all() const {
    std::vector<cell> cells;
    for (const auto& row : rows) cells.insert(cells.end(), row.begin(), row.end());
    return cells;
}

STAGECRAFT_INLINE value number_value(std::string text, std::size_t line) {
    return {false, false, false, false, {{{std::move(text), line}}}};
}

/// Entries of a file have at most 4096 characters.
STAGECRAFT_INLINE const std::string& bounded(const std::string& text) {
    if (text.size() > 4000) throw not_understood{"an expression of more than 4000 characters"};
    return text;
}

STAGECRAFT_INLINE std::string operand(const std::string& text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (depth > 0 || text[i] == ')' || std::isalnum(static_cast<unsigned char>(text[i])) != 0 ||
            text[i] == '.')
            continue;
        return "(" + text + ")";
    }
    return text.find(")(") == text.npos ? text : "(" + text + ")";
}

STAGECRAFT_INLINE value combined(value x, const std::string& sign, const value& y) {
    const auto join = [&](const cell& p, const cell& q) {
        if (sign == "^" && q.text == "0.5") return cell{bounded("sqrt(" + p.text + ")"), p.line};
        return cell{bounded(operand(p.text) + sign + operand(q.text)), p.line};
    };
    if (x.is_array && y.is_array) {
        if (x.rows.size() != y.rows.size() || (sign != "+" && sign != "-"))
            throw not_understood{"'" + sign + "' between two arrays"};
        for (std::size_t i = 0; i < x.rows.size(); ++i) {
            if (x.rows[i].size() != y.rows[i].size()) throw not_understood{"two arrays of different sizes"};
            for (std::size_t j = 0; j < x.rows[i].size(); ++j)
                x.rows[i][j] = join(x.rows[i][j], y.rows[i][j]);
        }
        return x;
    }
    if (y.is_array) {
        if (sign != "*") throw not_understood{"'" + sign + "' before an array"};
        value out = y;
        for (auto& row : out.rows)
            for (auto& c : row) c.text = bounded(operand(x.rows[0][0].text) + "*" + operand(c.text));
        return out;
    }
    if (x.is_array && sign != "*" && sign != "/") throw not_understood{"'" + sign + "' behind an array"};
    for (auto& row : x.rows)
        for (auto& c : row) c = join(c, y.rows[0][0]);
    return x;
}

STAGECRAFT_INLINE void reshape(value& v, bool by_columns) {
    v.rows = {v.all()};
    v.nested = false;
    v.reshaped = true;
    v.by_columns = by_columns;
}

STAGECRAFT_INLINE void transpose(value& v) {
    if (!v.is_array) return;
    if (v.reshaped) v.by_columns = !v.by_columns;
    if (!v.nested) return;
    const std::size_t width = v.rows.empty() ? 0 : v.rows.front().size();
    std::vector<std::vector<cell>> turned(width, std::vector<cell>(v.rows.size()));
    for (std::size_t i = 0; i < v.rows.size(); ++i) {
        if (v.rows[i].size() != width) throw not_understood{"a transposition of rows of different lengths"};
        for (std::size_t j = 0; j < width; ++j) turned[j][i] = v.rows[i][j];
    }
    v.rows = std::move(turned);
}

STAGECRAFT_INLINE value list(std::vector<value> parts) {
    value v{true, false, false, false, {}};
    v.nested = std::any_of(parts.begin(), parts.end(), [](const value& p) { return p.is_array; });
    if (!v.nested) v.rows.emplace_back();
    for (auto& p : parts) {
        if (p.is_array != v.nested) throw not_understood{"numbers beside rows"};
        if (!v.nested) v.rows.front().push_back(std::move(p.rows[0][0]));
        if (v.nested && parts.size() == 1 && p.nested) return std::move(p);  // {{ {..}, {..} }}
        if (v.nested && p.nested) throw not_understood{"an array of more than two dimensions"};
        if (v.nested) v.rows.push_back(p.all());
    }
    return v;
}

STAGECRAFT_INLINE value of_rows(std::vector<std::vector<value>> rows) {
    if (rows.size() == 1) return list(std::move(rows.front()));
    if (std::all_of(rows.begin(), rows.end(), [](const auto& r) { return r.size() == 1 && r[0].is_array; })) {
        std::vector<value> parts;  // rows in brackets, apart by lines
        for (auto& r : rows) parts.push_back(std::move(r.front()));
        return list(std::move(parts));
    }
    value v{true, true, false, false, {}};
    for (auto& r : rows) {
        value row = list(std::move(r));
        if (row.nested) throw not_understood{"rows of rows"};
        v.rows.push_back(std::move(row.rows.front()));
    }
    return v;
}

}  // namespace stagecraft::tableaux::program_text
