// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/tableaux/program_dense.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/program_names.hpp"

namespace stagecraft::tableaux::program_text {

/// How many numbers it has, also where they are assigned one by one.
STAGECRAFT_INLINE std::size_t numbers_of(const variable& x) {
    auto n = x.array.numbers();
    for (const auto& e : x.elements) n = std::max(n, e.column + 1);
    return n;
}

STAGECRAFT_INLINE void take_dense(groups& out, variables& v) {
    const bool only = out.all.size() == 1;
    for (auto& g : out.all) {
        const auto alone = std::count_if(out.all.begin(), out.all.end(),
                                         [&](const group& other) { return other.scope == g.scope; });
        if (alone > 1 || g.arrays.contains("b_theta") || !g.arrays.contains("b")) continue;
        const auto s = numbers_of(v.all[g.arrays.at("b")]);
        for (std::size_t k = 0; k < v.all.size(); ++k) {
            auto& x = v.all[k];
            const auto as = dense_as(x.last());
            if (!as || x.used || x.is != variable::kind::array || !x.trouble.empty() || !x.elements.empty())
                continue;
            if (x.scope != g.scope && !only) continue;
            const bool at_half = *as == dense_word::written::at_half;
            const auto n = at_half ? x.array.numbers() : x.array.rows.size();
            if (at_half == x.array.nested || (n != s && n != s + 1)) continue;
            g.arrays["b_theta"] = k;
            g.dense_as = *as;
            x.used = true;
            break;
        }
    }
}

/// The coefficients of theta to theta^4 of the polynomial b with b(0) = 0, b'(0) = first, b(1/2) = half, b(1) = weight and
/// b'(1) = last.
STAGECRAFT_INLINE std::vector<cell> quartic(const cell& half, const cell& weight, bool first, bool last) {
    const auto term = [&](int of_half, int of_weight, int constant) {
        const auto text = "(" + std::to_string(of_half) + ")*(" + half.text + ")+(" +
                          std::to_string(of_weight) + ")*(" + weight.text + ")+(" + std::to_string(constant) +
                          ")";
        return cell{bounded(text), half.line};
    };
    const int f = first ? 1 : 0, l = last ? 1 : 0;
    return {{std::to_string(f), half.line},
            term(16, -5, l - 4 * f),
            term(-32, 14, 5 * f - 3 * l),
            term(16, -8, 2 * l - 2 * f)};
}

STAGECRAFT_INLINE std::vector<std::vector<cell>> dense_of(const group& g, const variables& v,
                                                          const std::vector<cell>& b) {
    const auto at = g.arrays.find("b_theta");
    if (at == g.arrays.end()) return {};
    const auto& x = v.all[at->second];
    std::vector<std::vector<cell>> rows;
    if (g.dense_as == dense_word::written::at_half) {
        const auto half = x.array.all();
        for (std::size_t i = 0; i < half.size(); ++i)
            rows.push_back(
                quartic(half[i], i < b.size() ? b[i] : cell{"0", x.line}, i == 0, i + 1 == half.size()));
        return rows;
    }
    rows = x.array.rows;
    if (!x.array.nested && !b.empty() && x.array.numbers() % b.size() == 0) {  // one behind the other
        const auto all = x.array.all();
        const auto degree = all.size() / b.size();
        rows.assign(b.size(), {});
        for (std::size_t i = 0; i < all.size(); ++i) rows[i / degree].push_back(all[i]);
    }
    if (g.dense_as == dense_word::written::descending)
        for (auto& row : rows) std::reverse(row.begin(), row.end());
    return rows;
}

}  // namespace stagecraft::tableaux::program_text
