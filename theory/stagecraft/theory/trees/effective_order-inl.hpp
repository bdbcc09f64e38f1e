// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/trees/effective_order.hpp"

#include <map>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE effective_order_equations::effective_order_equations() {
    find_remains();
    beta.resize(largest_effective_order + 1);
    conditions.resize(largest_effective_order + 1);
    for (int n = 1; n <= largest_effective_order; ++n) eliminate(n);
}

STAGECRAFT_INLINE std::uint32_t effective_order_equations::product(std::uint32_t left,
                                                                   std::uint32_t right) const {
    const auto view = trees.view();
    const tree_row l = view.rows[left];
    if (l.order > 1 && right > l.right) return product(product(l.left, right), l.right);
    const int n = l.order + view.rows[right].order;
    for (std::uint32_t row = view.first[n]; row < view.first[n + 1]; ++row)
        if (view.rows[row].left == left && view.rows[row].right == right) return row;
    return view.first[n + 1];  // not reached: the table is complete
}

STAGECRAFT_INLINE void effective_order_equations::find_remains() {
    const auto view = trees.view();
    std::vector<std::map<std::uint32_t, rational>> all;
    all.push_back({{0U, rational(1)}});  // with the tree itself
    for (std::uint32_t row = 1; row < view.rows.size(); ++row) {
        const tree_row t = view.rows[row];
        std::map<std::uint32_t, rational> here;
        for (const auto& [left, factor] : all[t.left]) {
            here[left] += factor / rational(view.rows[t.right].density);  // the right factor is cut off
            for (const auto& [right, other] : all[t.right]) here[product(left, right)] += factor * other;
        }
        all.push_back(std::move(here));
    }
    for (std::uint32_t row = 0; row < all.size(); ++row) {
        all[row].erase(row);
        remains.emplace_back(all[row].begin(), all[row].end());
    }
}

/// What the beta of order n - 1 add to beta alpha - E beta: b^T 1 = 1 times it of a planted tree, and minus it where a leaf is cut.
STAGECRAFT_INLINE tableaux::dense<tableaux::rational> effective_order_equations::system(int n) const {
    const auto view = trees.view();
    const auto row0 = view.first[n], column0 = view.first[n - 1];
    tableaux::dense<rational> m(view.first[n + 1] - row0, n > 2 ? row0 - column0 : 0);
    for (Eigen::Index i = 0; i < m.rows(); ++i)
        for (Eigen::Index j = 0; j < m.cols(); ++j) m(i, j) = rational(0);
    if (m.cols() == 0) return m;
    for (std::uint32_t row = row0; row < view.first[n + 1]; ++row)
        for (const auto& [rest, factor] : remains[row])
            if (view.rows[rest].order == n - 1) m(row - row0, rest - column0) -= factor;
    for (std::uint32_t u = column0; u < row0; ++u) m(view.planted(u) - row0, u - column0) += rational(1);
    return m;
}

STAGECRAFT_INLINE void effective_order_equations::eliminate(int n) {
    const auto m = system(n);
    tableaux::dense<rational> work(m.rows(), m.cols() + m.rows());
    work.leftCols(m.cols()) = m;
    work.rightCols(m.rows()) = tableaux::identity<rational>(m.rows());
    const auto rank = static_cast<Eigen::Index>(tableaux::detail::eliminate<rational>(work, m.cols()).size());
    const auto at = static_cast<std::size_t>(n);
    beta[at] = work.topRightCorner(rank, m.rows());
    for (Eigen::Index i = 0; i < rank; ++i)
        for (Eigen::Index j = 0; j < m.rows(); ++j) beta[at](i, j) = rational(0) - beta[at](i, j);
    conditions[at] = work.bottomRightCorner(m.rows() - rank, m.rows());
}

STAGECRAFT_INLINE const effective_order_equations& equations_of_effective_order() {
    static const effective_order_equations equations;
    return equations;
}

}  // namespace stagecraft::theory
