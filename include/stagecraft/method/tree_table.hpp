// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/method/rooted_tree.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace stagecraft {

/// One tree of a table: t = left∘right, where `right` is the smallest child (by row number) of t's root and
/// `left` is what remains without it: g(t) = g(left) A g(right) for the stage vectors. The first row of a
/// table is tau, which has no factors.
struct tree_row {
    std::uint32_t left = 0;
    std::uint32_t right = 0;
    std::int16_t order = 1;
    std::int16_t multiplicity = 0;  ///< how many of the root's children equal `right`
    std::int32_t colour = 0;        ///< of the root
    std::int64_t density = 1;       ///< gamma
    std::int64_t symmetry = 1;      ///< sigma
};

/// All trees up to an order, by Butcher products: rows sorted by order, rows [first[n], first[n+1]) having
/// order n. The planted tree [x] of a row x of order n is row first[n+1] + (x - first[n]). A view; it does
/// not own its rows.
struct tree_view {
    std::span<const tree_row> rows;
    std::array<std::uint32_t, rooted_tree::max_order + 2> first{};
    int max_order = 0;
    bool has_time_leaf = false;

    /// The leaf that stands for the time: a `right` only, whose A g(right) is c. Row 1 where there is one.
    constexpr bool is_time_leaf(std::uint32_t i) const { return has_time_leaf && i == 1; }
    constexpr std::uint32_t planted(std::uint32_t x) const {
        const int n = rows[x].order;
        return first[n + 1] + (x - first[n]);
    }
    /// Row i as a value. Costs order(t)^2 at most.
    constexpr rooted_tree tree(std::uint32_t i) const {
        const tree_row& row = rows[i];
        return row.order == 1 ? rooted_tree{} : butcher_product(tree(row.left), tree(row.right));
    }
};

namespace detail {

/// Fills rows for all orders; every tree arises once, because its smallest child is split off. The number of
/// pairs looked at exceeds the number of trees by a small factor only. The vertices bear one of `colours`
/// colours; `admits(left, right)` says whether `right` may hang at the root of `left` besides its children.
template <class Admits, class Append>
constexpr void generate_trees(tree_view& view, int max_order, int colours, const Admits& admits,
                              const Append& append) {
    for (int k = 0; k < colours; ++k) {
        tree_row leaf;
        leaf.colour = k;
        append(leaf);
    }
    view.first[1] = 0;
    view.first[2] = static_cast<std::uint32_t>(colours);
    for (int n = 2; n <= max_order; ++n) {
        std::uint32_t next = view.first[n];
        for (int m = 1; m < n; ++m) {  // order of the left factor
            for (std::uint32_t l = view.first[m]; l < view.first[m + 1]; ++l) {
                const tree_row left = view.rows[l];
                for (std::uint32_t r = view.first[n - m]; r < view.first[n - m + 1]; ++r) {
                    if (m > 1 && r > left.right) break;
                    const tree_row& right = view.rows[r];
                    if (!admits(left, right)) continue;
                    tree_row t;
                    t.left = l;
                    t.right = r;
                    t.order = static_cast<std::int16_t>(n);
                    t.multiplicity =
                        static_cast<std::int16_t>(m > 1 && r == left.right ? left.multiplicity + 1 : 1);
                    t.colour = left.colour;
                    t.density = n * (left.density / m) * right.density;
                    t.symmetry = left.symmetry * right.symmetry * t.multiplicity;
                    append(t);
                    ++next;
                }
            }
        }
        view.first[n + 1] = next;
    }
    view.max_order = max_order;
}

/// Trees of one colour, and of two where the second is that of the time leaf, which bears no children.
struct admits_first_colour {
    constexpr bool operator()(const tree_row& left, const tree_row&) const { return left.colour == 0; }
};

}  // namespace detail

/// The trees of orders 1..max_order with their factors, densities and symmetries (run time; order 14 has
/// 53,272 rows of 32 bytes). Immutable once made. `with_time_leaf`: the trees of y' = f(t, y) where c is not
/// A 1, with leaves of two kinds (Hairer-Norsett-Wanner I.II.2 assumes c = A 1 to avoid them).
class tree_table {
  public:
    /// Throws std::invalid_argument for an order outside 1..20 (order 20 already has 12.8 million trees).
    explicit tree_table(int max_order, bool with_time_leaf = false) {
        view_.has_time_leaf = with_time_leaf;
        std::int64_t count = 0;
        for (int n = 1; n <= max_order; ++n) count += number_of_trees(n);
        if (count == 0) throw std::invalid_argument("max_order: trees have at least one vertex");
        rows_.reserve(static_cast<std::size_t>(count));
        generate(max_order, with_time_leaf ? 2 : 1, detail::admits_first_colour{});
    }
    /// Trees whose vertices have one of `colours` colours (P-trees, N-trees: Hairer-Norsett-Wanner I.II.14 and
    /// II.15). `admits(left, right)`: whether the tree of row `right` may hang at the root of `left` besides
    /// its children; what it admits must not depend on the order in which children are attached. Throws
    /// std::invalid_argument for an order outside 1..14 or colours outside 1..8.
    template <class Admits>
    tree_table(int max_order, int colours, const Admits& admits) {
        if (max_order < 1 || max_order > 14 || colours < 1 || colours > 8)
            throw std::invalid_argument("coloured trees: order 1 to 14, 1 to 8 colours");
        generate(max_order, colours, admits);
    }
    tree_table(const tree_table&) = delete;  // views point into it
    tree_table& operator=(const tree_table&) = delete;

    const tree_view& view() const { return view_; }
    std::size_t size() const { return rows_.size(); }

  private:
    template <class Admits>
    void generate(int max_order, int colours, const Admits& admits) {
        detail::generate_trees(view_, max_order, colours, admits, [this](const tree_row& row) {
            rows_.push_back(row);
            view_.rows = rows_;
        });
    }

    std::vector<tree_row> rows_;
    tree_view view_;
};

/// The same table as a compile-time constant.
template <int MaxOrder>
class fixed_tree_table {
    static constexpr std::size_t count = [] {
        std::int64_t sum = 0;
        for (int n = 1; n <= MaxOrder; ++n) sum += number_of_trees(n);
        return static_cast<std::size_t>(sum);
    }();

  public:
    constexpr fixed_tree_table() {
        tree_view view;
        std::size_t used = 0;
        detail::generate_trees(view, MaxOrder, 1, detail::admits_first_colour{}, [&](const tree_row& row) {
            rows_[used++] = row;
            view.rows = {rows_.data(), used};
        });
        first_ = view.first;
    }
    constexpr tree_view view() const { return {rows_, first_, MaxOrder}; }
    static constexpr std::size_t size() { return count; }

  private:
    std::array<tree_row, count> rows_{};
    std::array<std::uint32_t, rooted_tree::max_order + 2> first_{};
};

}  // namespace stagecraft
