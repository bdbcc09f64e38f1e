// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <stagecraft/method/tree_table.hpp>
#include <stagecraft/tableau.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/trees/tree_weights.hpp>
#include <utility>
#include <vector>

/// The modified equation of a method, whose exact flow makes its steps, as a B-series, and how far the energy of Hamiltonian
/// systems is constant along it.

namespace stagecraft::theory {

/// How far modified equations are looked at.
inline constexpr int largest_modified_order = 8;

/// What is the same for all methods: of each tree the pairs (rest with its root, subtree) that cutting one edge leaves, as often
/// as an edge leaves them; and of each order n the free trees of n + 1 vertices by their elementary Hamiltonians: for each the
/// rows t of order n for which the tree t with one more leaf at its root is that free tree, with sign. Free trees
/// whose elementary Hamiltonian vanishes are left out (Hairer-Lubich-Wanner, sections IX.9 and IX.10).
struct modified_equation_trees {
    struct cut {
        std::uint32_t rest, subtree;
        std::int64_t times;
    };
    struct signed_tree {
        std::uint32_t row;
        int sign;
    };
    tree_table trees{largest_modified_order + 1};
    std::vector<std::vector<cut>> cuts;  ///< by row, of orders to largest_modified_order
    std::vector<std::vector<std::vector<signed_tree>>> energy_classes;  ///< by order

    modified_equation_trees();

  private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> rows_;
    std::uint32_t product(std::uint32_t left, std::uint32_t right) const;
    void find_cuts();
    void find_classes(int order);
};

/// Made once.
const modified_equation_trees& trees_of_modified_equation();

/// The coefficients b(t) of h y' = sum h^|t|/sigma(t) b(t) F(t)(y), whose flow after h is the step of the method: a = b + d_b b/2! +
/// d_b^2 b/3! + ... with the elementary weights a and the derivation d_b c(t) = sum over cuts c(rest) b(subtree)
/// (Hairer-Lubich-Wanner, section IX.9). Order by order; O(n) operations for each cut.
template <class K>
class modified_equation_walk {
  public:
    explicit modified_equation_walk(const tableau<K>& t)
        : table_(trees_of_modified_equation()),
          view_(table_.trees.view()),
          model_(t),
          weights_(model_, view_, largest_modified_order) {}

    /// Goes on to the next order, at most largest_modified_order: its b(t), in the order of the table.
    std::vector<K> advance() {
        weights_.advance();
        const int n = weights_.order();
        std::vector<K> found;
        for (std::size_t i = 0; i < weights_.weights().size(); ++i) {
            const auto row = weights_.first_row() + static_cast<std::uint32_t>(i);
            std::vector<K> powers(1, K(0));  // d_b^j b(t); b(t) itself is what is sought
            K inverse_factorial_sum(0);
            std::int64_t factorial = 1;
            for (int j = 1; j < n; ++j) {
                K sum(0);
                for (const auto& [rest, subtree, times] : table_.cuts[row])
                    if (static_cast<std::size_t>(j) <= derived_[rest].size())
                        sum = sum + derived_[rest][static_cast<std::size_t>(j) - 1] * derived_[subtree][0] *
                                        K(times);
                powers.push_back(sum);
                factorial *= j + 1;
                inverse_factorial_sum = inverse_factorial_sum + sum / K(factorial);
            }
            // a(t) = weight |t|/gamma(t) in the scale of tree_weights
            const K weight = weights_.weights()[i] * K(n) / K(view_.rows[row].density);
            powers[0] = weight - inverse_factorial_sum;
            found.push_back(powers[0]);
            derived_.push_back(std::move(powers));
        }
        return found;
    }

    /// What is left of the energy, for each free tree: the sum of +-b(t)/sigma(t) over `b`, which advance() has returned.
    std::vector<K> energy_conditions(const std::vector<K>& b) const {
        const auto first = weights_.first_row();
        std::vector<K> all;
        for (const auto& members : table_.energy_classes[static_cast<std::size_t>(weights_.order())]) {
            K sum(0);
            for (const auto& [row, sign] : members)
                sum = sum + b[row - first] * K(sign) / K(view_.rows[row].symmetry);
            all.push_back(sum);
        }
        return all;
    }

  private:
    const modified_equation_trees& table_;
    tree_view view_;
    matrix_model<K> model_;
    tree_weights<matrix_model<K>> weights_;
    std::vector<std::vector<K>> derived_;  // by row: b, d_b b, ..., d_b^(|t| - 1) b
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/trees/modified_equation-inl.hpp"
#endif
