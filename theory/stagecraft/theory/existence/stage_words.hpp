// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <stagecraft/tableaux/rational.hpp>
#include <stagecraft/theory/existence/sought_method.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// Stages of a method, bit i for stage i: where a vector need not vanish.
using stage_set = std::uint64_t;

/// A pointwise product of powers of nodes and of factors; stages outside `support` are zero.
struct stage_word {
    std::vector<int> powers;           ///< of each vector of nodes
    std::vector<std::size_t> factors;  ///< sorted
    stage_set support = 0;
};

/// A factor: A v for a word v; or the defect k A c^(k-1) - c^k of C(k), which vanishes in the rows where C(k) holds.
struct stage_factor {
    std::size_t matrix = 0;
    std::size_t node = 0;    ///< of a defect: which c
    int k = 0;               ///< of a defect; 0 for A v
    std::size_t inside = 0;  ///< v
    stage_set support = 0;
};

/// A row vector: weights themselves, or (u * v)^T A for a row vector u and a word v.
struct row_word {
    bool is_weights = true;
    std::size_t of = 0;  ///< the weights, or u
    std::size_t left = 0, matrix = 0;
    stage_set support = 0;
};

/// Words by number with rational factors.
using word_sum = std::map<std::size_t, tableaux::rational>;

namespace detail {

inline stage_set bit(std::size_t i) { return stage_set{1} << i; }
stage_set all_stages(int s);
void add_to(word_sum& sum, std::size_t word, const tableaux::rational& x);

}  // namespace detail

/// Stage vectors of all methods with the zeros of a given one and some of its C(k), formally: each word is kept once, words
/// that vanish are dropped. A c^(k-1) becomes (c^k + defect)/k.
class stage_words {
  public:
    /// The rows in which C(k) with this matrix and these nodes is not to be relied on.
    using failing_rows = std::function<stage_set(std::size_t matrix, std::size_t node, int k)>;

    stage_words(const sought_method& method, failing_rows fails);

    const std::vector<stage_word>& words() const { return words_; }
    const std::vector<stage_factor>& factors() const { return factors_; }
    const std::vector<row_word>& rows() const { return rows_; }

    std::size_t one() const { return 0; }
    word_sum multiply(const word_sum& x, const word_sum& y);
    word_sum apply(std::size_t matrix, const word_sum& x);
    /// c^k.
    std::size_t power(std::size_t node, int k);
    /// x y; empty support where it vanishes.
    std::size_t product(std::size_t x, std::size_t y);
    /// The word without one of its factors.
    std::size_t without(std::size_t word, std::size_t factor);

    std::size_t weights(std::size_t number) const { return number; }
    /// (u * left)^T A.
    std::size_t row(std::size_t u, std::size_t left, std::size_t matrix);
    /// Whether the word is a power of one vector of nodes: which and k. 1 is c^0 of `of_matrix`'s nodes.
    bool is_power(std::size_t word, std::size_t of_matrix, std::size_t& node, int& k) const;

  private:
    std::size_t keep(stage_word w);
    std::size_t factor(stage_factor f);

    const sought_method& method_;
    failing_rows fails_;
    std::vector<stage_word> words_;
    std::vector<stage_factor> factors_;
    std::vector<row_word> rows_;
    std::map<std::pair<std::vector<int>, std::vector<std::size_t>>, std::size_t> word_numbers_;
    std::map<std::tuple<std::size_t, std::size_t, int, std::size_t>, std::size_t> factor_numbers_;
    std::map<std::tuple<std::size_t, std::size_t, std::size_t>, std::size_t> row_numbers_;
};

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/existence/stage_words-inl.hpp"
#endif
