// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/trees/modified_equation.hpp"

#include <numeric>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE modified_equation_trees::modified_equation_trees() {
    const auto view = trees.view();
    for (std::uint32_t row = 1; row < view.rows.size(); ++row)
        rows_[{view.rows[row].left, view.rows[row].right}] = row;
    find_cuts();
    energy_classes.resize(largest_modified_order + 1);
    for (int n = 2; n <= largest_modified_order; ++n) find_classes(n);
    rows_.clear();
}

STAGECRAFT_INLINE std::uint32_t modified_equation_trees::product(std::uint32_t left,
                                                                 std::uint32_t right) const {
    const tree_row l = trees.view().rows[left];
    if (l.order > 1 && right > l.right) return product(product(l.left, right), l.right);
    return rows_.at({left, right});
}

STAGECRAFT_INLINE void modified_equation_trees::find_cuts() {
    const auto view = trees.view();
    cuts.resize(1);
    for (std::uint32_t row = 1; row < view.first[largest_modified_order + 1]; ++row) {
        const tree_row t = view.rows[row];
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> here;
        ++here[{t.left, t.right}];
        for (const auto& c : cuts[t.left]) here[{product(c.rest, t.right), c.subtree}] += c.times;
        for (const auto& c : cuts[t.right]) here[{product(t.left, c.rest), c.subtree}] += c.times;
        cuts.emplace_back();
        for (const auto& [pair, times] : here) cuts.back().push_back({pair.first, pair.second, times});
    }
}

/// Rows of order n + 1 are linked where they are one free tree: u with v at its root, and v with u at its root, which has the opposite
/// elementary Hamiltonian.
STAGECRAFT_INLINE void modified_equation_trees::find_classes(int n) {
    const auto view = trees.view();
    const auto first = view.first[n + 1], end = view.first[n + 2];
    std::vector<std::uint32_t> parent(end - first);
    std::vector<int> sign(end - first, 1);  // relative to the parent
    std::vector<bool> vanishes(end - first);
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t x) {
        int s = 1;
        for (; parent[x] != x; x = parent[x]) s *= sign[x];
        return std::pair(x, s);
    };
    for (int m = 1; m <= n; ++m)
        for (auto u = view.first[m]; u < view.first[m + 1]; ++u)
            for (auto v = view.first[n + 1 - m]; v < view.first[n + 2 - m]; ++v) {
                const auto [x, a] = root(product(u, v) - first);
                const auto [y, b] = root(product(v, u) - first);
                if (x == y) {
                    vanishes[x] = vanishes[x] || a == b;
                    continue;
                }
                parent[x] = y;
                sign[x] = -a * b;
                vanishes[y] = vanishes[y] || vanishes[x];
            }
    std::map<std::uint32_t, std::vector<signed_tree>> classes;
    for (auto t = view.first[n]; t < view.first[n + 1]; ++t) {
        const auto [x, s] = root(product(t, 0) - first);
        if (!vanishes[x]) classes[x].push_back({t, s});
    }
    for (auto& [x, members] : classes)
        energy_classes[static_cast<std::size_t>(n)].push_back(std::move(members));
}

STAGECRAFT_INLINE const modified_equation_trees& trees_of_modified_equation() {
    static const modified_equation_trees all;
    return all;
}

}  // namespace stagecraft::theory
