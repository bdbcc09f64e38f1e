// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/method/tree_table.hpp>
#include <stagecraft/theory/models/fixed_buffer.hpp>
#include <stagecraft/theory/models/stage_algebra.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace stagecraft::theory {

using stagecraft::tree_row;
using stagecraft::tree_table;
using stagecraft::tree_view;

namespace detail {

// An index that std::vector can hold in a constant expression (clang 14 refuses trivial types there).
struct slot {
    std::uint32_t value;
    constexpr slot(std::uint32_t v = none) : value(v) {}
    static constexpr std::uint32_t none = 0xffffffffU;
};

// A hash table from pairs of indices to an index, for one order of trees; open addressing.
class pair_memo {
  public:
    explicit constexpr pair_memo(std::uint32_t entries) : table_(size_for(entries)) {}
    // The value stored for (a, b), `slot::none` when there is none yet; to be assigned by the caller.
    constexpr std::uint32_t& find(std::uint32_t a, std::uint32_t b) {
        const auto mask = static_cast<std::size_t>(table_.size()) - 1;
        std::size_t i = (std::size_t{a} * 0x9e3779b1U + std::size_t{b} * 0x85ebca6bU) >> 3 & mask;
        entry* const table = table_.data();
        while (table[i].value != slot::none && (table[i].a != a || table[i].b != b)) i = (i + 1) & mask;
        table[i].a = a;
        table[i].b = b;
        return table[i].value;
    }

  private:
    struct entry {
        std::uint32_t a, b, value;
        constexpr entry() : a(0), b(0), value(slot::none) {}
    };
    static constexpr int size_for(std::uint32_t entries) {
        std::uint32_t size = 4;
        while (size < 2 * entries) size *= 2;
        return static_cast<int>(size);
    }
    fixed_buffer<entry> table_;
};

}  // namespace detail

/// The elementary weights of a method, order by order, by memoised Butcher products.
///
/// With g(tau) = 1, g(t∘u) = g(t) A g(u) the elementary weight of t is b^T g(t) (Butcher;
/// Hairer-Norsett-Wanner I.II.2, Definition 2.9). Kept are the normalised vectors gamma(t)/|t| g(t): they
/// equal c^{|t|-1} wherever C(q) reaches, obey the same recursion with |u| A in place of A, and the condition
/// of t reads `weight(t) == 1/|t|`. Over exact fields equal vectors are stored once and a product of two
/// stored vectors is computed once, so that a method of high stage order costs a handful of products;
/// floating scalars take each tree in turn, s^2 operations for a planted tree and s for any other.
template <stage_algebra M>
class tree_weights {
  public:
    using scalar = scalar_of<M>;
    using element = element_of<M>;

    /// Weights to order `max_order`. Keeps references: `model` and the table behind `trees` must outlive it.
    /// Throws std::invalid_argument when the table ends before `max_order` or `max_order` < 1.
    constexpr tree_weights(const M& model, const tree_view& trees, int max_order)
        : model_(&model), trees_(trees), max_order_(max_order) {
        if (max_order < 1 || max_order > trees.max_order)
            throw std::invalid_argument("max_order: outside the table of trees");
    }

    /// The order whose weights `weights()` holds; 0 before the first `advance()`.
    constexpr int order() const { return order_; }
    /// Row number of the first tree of `order()`.
    constexpr std::uint32_t first_row() const { return trees_.first[order_]; }
    /// The normalised weights gamma(t)/|t| b^T g(t) of the trees of `order()`, in the order of the table.
    constexpr const std::vector<scalar>& weights() const { return weights_; }

    /// gamma times elementary weight, minus 1, for tree number i of `order()`: zero where its condition
    /// holds.
    constexpr scalar defect(std::size_t i) const { return weights_[i] * scalar(order_) - scalar(1); }
    /// Elementary weight minus 1/gamma: the residual of the order condition.
    constexpr scalar residual(std::size_t i) const {
        return defect(i) / scalar(trees_.rows[first_row() + i].density);
    }

    /// Goes on to the next order; false when `max_order` has been reached.
    constexpr bool advance() {
        if (order_ == max_order_) return false;
        ++order_;
        const std::uint32_t count = trees_.first[order_ + 1] - trees_.first[order_];
        weights_.clear();
        weights_.reserve(count);
        if (order_ == 1) {
            elements_.push_back(model_->one());
            slots_.emplace_back(0U);
            weights_.push_back(model_->dot_b(elements_[0]));
        } else if constexpr (sharing) {
            advance_shared(count);
        } else {
            advance_directly(count);
        }
        return true;
    }

  private:
    static constexpr bool sharing = exact_scalar<scalar> && requires(const element& u, const element& v) {
        u < v;
    };
    static constexpr bool has_functionals = requires(const M& m, const element& v) {
        m.pair(m.weigh(m.weights(), v), v);
    };

    constexpr const element& g(std::uint32_t row) const {
        if constexpr (sharing)
            return elements_[slots_[row].value];
        else
            return elements_[row];
    }
    // (No ?: below: g++ 12 destroys its class results twice in constant expressions.)
    constexpr element vector_of(const tree_row& t) const {
        if (t.left == 0) return scale(*model_, scalar(order_ - 1), model_->apply(g(t.right)));
        return model_->multiply(g(trees_.planted(t.right)), g(t.left));  // the simpler factor first
    }
    constexpr scalar weight_of(const tree_row& t) const {
        if (t.left == 0) return scalar(order_ - 1) * dot_b_apply(*model_, g(t.right));
        return inner(*model_, g(t.left), g(trees_.planted(t.right)));
    }

    constexpr void advance_directly(std::uint32_t count) {
        const std::uint32_t first = first_row();
        if (order_ < max_order_) {
            elements_.reserve(first + count);
            for (std::uint32_t t = first; t < first + count; ++t) {
                elements_.push_back(vector_of(trees_.rows[t]));
                weights_.push_back(model_->dot_b(elements_.back()));
            }
        } else if constexpr (has_functionals) {
            // The smallest of two or more children has at most (order - 1)/2 vertices: few weighted vectors.
            std::vector<element> weighted;
            for (std::uint32_t r = 0; r < trees_.first[(order_ - 1) / 2 + 1]; ++r)
                weighted.push_back(model_->weigh(model_->weights(), g(trees_.planted(r))));
            for (std::uint32_t t = first; t < first + count; ++t) {
                const tree_row& row = trees_.rows[t];
                weights_.push_back(row.left == 0 ? weight_of(row)
                                                 : model_->pair(weighted[row.right], g(row.left)));
            }
        } else {
            for (std::uint32_t t = first; t < first + count; ++t)
                weights_.push_back(weight_of(trees_.rows[t]));
        }
    }

    constexpr void advance_shared(std::uint32_t count) {
        const std::uint32_t first = first_row();
        const bool keep = order_ < max_order_;
        detail::pair_memo memo(count);
        std::vector<scalar> results;  // weights of what this order has made so far, each once
        fixed_buffer<detail::slot> sorted(keep ? static_cast<int>(count) : 0);  // its vectors, by value
        detail::slot* const first_sorted = sorted.data();
        detail::slot* end_sorted = first_sorted;
        const auto made = static_cast<std::uint32_t>(elements_.size());
        for (std::uint32_t t = first; t < first + count; ++t) {
            const tree_row& row = trees_.rows[t];
            std::uint32_t& known =
                row.left == 0 ? memo.find(detail::slot::none, slots_[row.right].value)
                              : memo.find(slots_[row.left].value, slots_[trees_.planted(row.right)].value);
            if (known == detail::slot::none) {
                if (keep) {
                    element v = vector_of(row);
                    detail::slot* const at = std::lower_bound(
                        first_sorted, end_sorted, v,
                        [this](const detail::slot& s, const element& x) { return elements_[s.value] < x; });
                    if (at != end_sorted && elements_[at->value] == v) {
                        known = at->value - made;
                    } else {
                        known = static_cast<std::uint32_t>(elements_.size()) - made;
                        std::copy_backward(at, end_sorted, end_sorted + 1);
                        ++end_sorted;
                        *at = detail::slot(known + made);
                        results.push_back(model_->dot_b(v));
                        elements_.push_back(std::move(v));
                    }
                } else {
                    known = static_cast<std::uint32_t>(results.size());
                    results.push_back(weight_of(row));
                }
            }
            if (keep) slots_.emplace_back(known + made);
            weights_.push_back(results[known]);
        }
    }

    const M* model_;
    tree_view trees_;
    int max_order_;
    int order_ = 0;
    std::vector<element> elements_;    // normalised g, by row or by slot
    std::vector<detail::slot> slots_;  // where sharing: which element belongs to a row
    std::vector<scalar> weights_;
};

}  // namespace stagecraft::theory
