// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <stagecraft/method/tree_table.hpp>
#include <stagecraft/tableaux/ball.hpp>
#include <stagecraft/theory/existence/word_values.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// An equation for the numbers of a method.
struct order_equation {
    enum class kind {
        stage,    ///< C(k) in row `index`
        adjoint,  ///< D(k) in column `index`
        row,      ///< a row vector of `words` vanishes in column `index`
        weights   ///< weights times a sum of words is `right`
    } is = kind::stage;
    std::size_t matrix = 0, node = 0;
    int k = 0;
    std::size_t index = 0;
    std::size_t row = 0;  ///< the row vector, or the weights
    word_sum words;
    tableaux::rational right = 0;
};

/// What equations to solve so that all order conditions hold.
struct order_goal {
    std::vector<int> orders;  ///< of b and b_embedded: weights k has orders[k / partners]
    int most_stages = 64;     ///< C(k) beyond is not made use of, whether it holds or not
};

/// How clear it was which identities hold in the tables as they are written.
struct identity_gap {
    tableaux::bound holds = 0;  ///< the largest residual of one that is taken to hold
    tableaux::bound fails = 1;  ///< the smallest of one that is not
    bool open = false;          ///< some residual is known too coarsely to tell
};

/// Equations from which the conditions of all trees follow, by linear algebra over Q:
///
/// 1. C(k) where it holds up to rounding: A c^(k-1) = (c^k + defect)/k, and defects are zero in those rows;
/// 2. rows such as b^T A, b^T C A that vanish in the columns that meet a defect (subquadrature), and D(k);
/// 3. what is left of b^T g(t) = 1/gamma(t), of which those that follow from others, as linear forms in words over Q, are
///    dropped.
///
/// The reduction is an equality for every method that satisfies 1 and 2, so that a method that satisfies all equations has
/// the order. (Butcher 1964 and Hairer-Norsett-Wanner I.II.1, II.5 reduce the conditions so by hand.)
class order_system {
  public:
    /// `trees` of all colours to the highest of the orders. Throws tableaux::undecided where c is not A 1, and where the
    /// conditions contradict the zeros and identities.
    order_system(const sought_method& method, const tree_view& trees, const order_goal& goal);
    order_system(const order_system&) = delete;
    order_system& operator=(const order_system&) = delete;

    const sought_method& method() const { return method_; }
    const std::vector<order_equation>& equations() const { return equations_; }
    const identity_gap& gap() const { return gap_; }
    /// Pairs of nodes of which a dropped equation needs that they differ.
    const std::set<std::pair<std::size_t, std::size_t>>& distinct() const { return distinct_; }
    const stage_words& words() const { return words_; }
    /// "C(2) in row 3", "D(1) in column 4", ...
    std::string name(const order_equation& e) const;

    /// Left minus right side.
    template <class K, class Convert>
    K residual(const order_equation& e, word_values<K>& at, const Convert& convert) const {
        switch (e.is) {
            case order_equation::kind::stage:
                return at.defect(e.matrix, e.node, e.k, e.index);
            case order_equation::kind::adjoint:
                return at.adjoint_defect(e.row, e.matrix, e.node, e.k, e.index);
            case order_equation::kind::row:
                return at.row(e.row)[e.index];
            default:
                K sum = convert(-e.right);
                for (const auto& [word, by] : e.words) sum = sum + convert(by) * at.weighted(e.row, word);
                return sum;
        }
    }

  private:
    std::string row_name(std::size_t row) const;
    std::string word_name(std::size_t word) const;
    bool holds(const tableaux::ball& residual);
    void impose(order_equation e);
    stage_set failing_rows(std::size_t matrix, std::size_t node, int k);
    bool annihilated(std::size_t row, std::size_t word);
    bool holds_adjoint(std::size_t weights, std::size_t matrix, int k, stage_set columns);
    word_sum reduced(std::size_t weights, std::size_t word);
    bool by_adjoint(std::size_t weights, std::size_t word, word_sum& out);
    void require(std::size_t weights, word_sum form, tableaux::rational right);
    order_equation adjoint_equation(std::size_t weights, std::size_t matrix, int k, std::size_t column);
    bool trivial_adjoint(std::size_t weights, std::size_t matrix, std::size_t column) const;
    void drop_adjoint_syzygies(std::size_t w, std::size_t n, int k, int order);

    using equation_key = std::tuple<int, std::size_t, std::size_t, int, std::size_t, std::size_t>;
    static equation_key key(const order_equation& e) {
        return {static_cast<int>(e.is), e.matrix, e.node, e.k, e.index, e.row};
    }

    sought_method method_;
    int most_stages_;
    stage_words words_;
    word_values<tableaux::ball> written_;
    identity_gap gap_;
    std::vector<order_equation> equations_;
    std::set<equation_key> imposed_;
    std::map<std::tuple<std::size_t, std::size_t, int>, stage_set> failing_;
    std::map<std::pair<std::size_t, std::size_t>, bool> annihilated_;
    std::map<std::pair<std::size_t, std::size_t>, order_equation> by_pivot_;  // weights and word
    std::set<std::pair<std::size_t, std::size_t>> distinct_;
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/existence/order_system-inl.hpp"
#endif
