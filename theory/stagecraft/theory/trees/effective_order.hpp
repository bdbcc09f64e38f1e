// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <stagecraft/method/tree_table.hpp>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/tableaux/small_solve.hpp>
#include <utility>
#include <vector>

/// Effective order (Butcher 1969): a method alpha has it where for some method beta the steps beta, alpha, beta^-1 one after
/// the other have that order, so that beta alpha = E beta for B-series, E the exact flow.

namespace stagecraft::theory {

/// How far effective orders are looked at.
inline constexpr int largest_effective_order = 6;

/// What is the same for all methods. Of each tree t: those that remain with its root where subtrees are cut off, each with
/// the product of the 1/gamma of what is cut (Hairer-Norsett-Wanner I.II.12, Theorem 12.6), t itself and nothing left over left
/// out. Of each order n: `beta`(t) of the trees of order n - 1 and `conditions`, which have to vanish, as linear combinations of what
/// beta alpha - E beta is for the trees of order n with beta = 0 for all of order n - 1 and more.
struct effective_order_equations {
    using rational = tableaux::rational;
    tree_table trees{largest_effective_order};
    std::vector<std::vector<std::pair<std::uint32_t, rational>>> remains;  ///< by row
    std::vector<tableaux::dense<rational>> beta, conditions;               ///< by order

    effective_order_equations();
    /// The row of `left` with `right` at its root.
    std::uint32_t product(std::uint32_t left, std::uint32_t right) const;

  private:
    void find_remains();
    void eliminate(int order);
    tableaux::dense<rational> system(int order) const;
};

/// Made once.
const effective_order_equations& equations_of_effective_order();

namespace detail {

/// q x; enclosures keep the precision of x.
template <class K>
K times(const tableaux::rational& q, const K& x) {
    return x * K(static_cast<std::int64_t>(q.numerator())) / K(static_cast<std::int64_t>(q.denominator()));
}

}  // namespace detail

/// Goes through the conditions order by order; beta is found on the way, with beta = 0 for the tree of one node.
template <class K>
class effective_order_walk {
  public:
    explicit effective_order_walk(const tableau<K>& t)
        : t_(t), equations_(equations_of_effective_order()), view_(equations_.trees.view()) {}

    /// The conditions of the next order, 1, ..., largest_effective_order; they hold where all are 0. To be called only where
    /// those before hold. O(s^2) operations for each tree.
    std::vector<K> advance() {
        const int n = ++order_;
        std::vector<K> left;
        for (std::uint32_t row = view_.first[n]; row < view_.first[n + 1]; ++row)
            left.push_back(left_over(row));
        const auto at = static_cast<std::size_t>(n);
        const auto unknown = combined(equations_.beta[at], left);
        for (std::size_t i = 0; i < unknown.size(); ++i)
            set_beta(view_.first[n - 1] + static_cast<std::uint32_t>(i), unknown[i]);
        return combined(equations_.conditions[at], left);
    }

  private:
    using column = std::vector<K>;

    static std::vector<K> combined(const tableaux::dense<tableaux::rational>& m, const std::vector<K>& v) {
        std::vector<K> out;
        for (Eigen::Index i = 0; i < m.rows(); ++i) {
            K sum(0);
            for (Eigen::Index j = 0; j < m.cols(); ++j)
                if (m(i, j) != 0) sum = sum + detail::times(m(i, j), v[static_cast<std::size_t>(j)]);
            out.push_back(sum);
        }
        return out;
    }
    /// beta alpha - E beta of a tree without the beta of order n - 1 and more; the stages of alpha behind beta.
    K left_over(std::uint32_t row) {
        const auto& tree = view_.rows[row];
        const auto s = static_cast<std::size_t>(t_.stages());
        column slope(s, K(1));
        if (tree.order > 1)
            for (std::size_t i = 0; i < s; ++i) slope[i] = slopes_[tree.left][i] * stages_[tree.right][i];
        K sum(0);
        for (std::size_t i = 0; i < s; ++i) sum = sum + t_.b(static_cast<int>(i)) * slope[i];
        sum = (sum * K(tree.density) - K(1)) / K(tree.density);
        for (const auto& [rest, factor] : equations_.remains[row])
            if (view_.rows[rest].order + 1 < tree.order) sum = sum - detail::times(factor, beta_[rest]);
        column stage(s, K(0));
        for (std::size_t i = 0; i < s; ++i)
            for (std::size_t j = 0; j < s; ++j)
                stage[i] = stage[i] + t_.A(static_cast<int>(i), static_cast<int>(j)) * slope[j];
        slopes_.push_back(std::move(slope));
        stages_.push_back(std::move(stage));
        beta_.push_back(K(0));
        return sum;
    }
    void set_beta(std::uint32_t row, const K& value) {
        beta_[row] = value;
        auto& planted = slopes_[view_.planted(row)];
        for (std::size_t i = 0; i < planted.size(); ++i) {
            stages_[row][i] = stages_[row][i] + value;
            planted[i] = stages_[row][i];
        }
        auto& above = stages_[view_.planted(row)];
        for (std::size_t i = 0; i < above.size(); ++i) {
            above[i] = K(0);
            for (std::size_t j = 0; j < planted.size(); ++j)
                above[i] = above[i] + t_.A(static_cast<int>(i), static_cast<int>(j)) * planted[j];
        }
    }

    const tableau<K>& t_;
    const effective_order_equations& equations_;
    tree_view view_;
    int order_ = 0;
    std::vector<column> slopes_, stages_;  // by row
    std::vector<K> beta_;
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/trees/effective_order-inl.hpp"
#endif
