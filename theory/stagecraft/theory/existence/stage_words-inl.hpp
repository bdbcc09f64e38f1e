// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/existence/stage_words.hpp"

#include <algorithm>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE stage_set all_stages(int s) {
    return s == 64 ? ~stage_set{0} : bit(static_cast<std::size_t>(s)) - 1;
}

/// Which of the numbers are not the number 0.
STAGECRAFT_INLINE stage_set nonzeros(const sought_method::row& row) {
    stage_set found = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
        if (row[i] != 0) found |= bit(i);
    return found;
}

STAGECRAFT_INLINE void add_to(word_sum& sum, std::size_t word, const tableaux::rational& x) {
    const auto [place, is_new] = sum.try_emplace(word, x);
    if (is_new) return;
    place->second += x;
    if (place->second == 0) sum.erase(place);
}

}  // namespace detail

STAGECRAFT_INLINE stage_words::stage_words(const sought_method& method, failing_rows fails)
    : method_(method), fails_(std::move(fails)) {
    keep({std::vector<int>(method.nodes.size(), 0), {}, 0});
    for (std::size_t k = 0; k < method.weights.size(); ++k)
        rows_.push_back({true, k, 0, 0, detail::nonzeros(method.weights[k])});
}

STAGECRAFT_INLINE std::size_t stage_words::keep(stage_word w) {
    const auto key = std::pair(w.powers, w.factors);
    const auto found = word_numbers_.find(key);
    if (found != word_numbers_.end()) return found->second;
    w.support = detail::all_stages(method_.stages);
    for (std::size_t m = 0; m < w.powers.size(); ++m)
        if (w.powers[m] > 0) w.support &= detail::nonzeros(method_.nodes[m]);
    for (const std::size_t f : w.factors) w.support &= factors_[f].support;
    word_numbers_.emplace(key, words_.size());
    words_.push_back(std::move(w));
    return words_.size() - 1;
}

STAGECRAFT_INLINE std::size_t stage_words::factor(stage_factor f) {
    const auto [place, is_new] =
        factor_numbers_.try_emplace({f.matrix, f.node, f.k, f.inside}, factors_.size());
    if (!is_new) return place->second;
    if (f.k > 0) {
        f.support = fails_(f.matrix, f.node, f.k);
    } else {
        for (std::size_t i = 0; i < method_.A[f.matrix].size(); ++i)
            if ((detail::nonzeros(method_.A[f.matrix][i]) & words_[f.inside].support) != 0)
                f.support |= detail::bit(i);
    }
    factors_.push_back(f);
    return factors_.size() - 1;
}

STAGECRAFT_INLINE std::size_t stage_words::power(std::size_t node, int k) {
    stage_word w{std::vector<int>(method_.nodes.size(), 0), {}, 0};
    w.powers[node] = k;
    return keep(std::move(w));
}

STAGECRAFT_INLINE std::size_t stage_words::product(std::size_t x, std::size_t y) {
    stage_word w = words_[x];
    for (std::size_t m = 0; m < w.powers.size(); ++m) w.powers[m] += words_[y].powers[m];
    w.factors.insert(w.factors.end(), words_[y].factors.begin(), words_[y].factors.end());
    std::sort(w.factors.begin(), w.factors.end());
    return keep(std::move(w));
}

STAGECRAFT_INLINE std::size_t stage_words::without(std::size_t word, std::size_t factor) {
    stage_word w = words_[word];
    w.factors.erase(std::find(w.factors.begin(), w.factors.end(), factor));
    return keep(std::move(w));
}

STAGECRAFT_INLINE word_sum stage_words::multiply(const word_sum& x, const word_sum& y) {
    word_sum sum;
    for (const auto& [u, a] : x)
        for (const auto& [v, b] : y) {
            const std::size_t w = product(u, v);
            if (words_[w].support != 0) detail::add_to(sum, w, a * b);
        }
    return sum;
}

STAGECRAFT_INLINE bool stage_words::is_power(std::size_t word, std::size_t of_matrix, std::size_t& node,
                                             int& k) const {
    const stage_word& w = words_[word];
    if (!w.factors.empty()) return false;
    node = method_.node_of[of_matrix];
    k = 0;
    for (std::size_t m = 0; m < w.powers.size(); ++m) {
        if (w.powers[m] == 0) continue;
        if (k > 0) return false;
        node = m;
        k = w.powers[m];
    }
    return true;
}

STAGECRAFT_INLINE word_sum stage_words::apply(std::size_t matrix, const word_sum& x) {
    word_sum sum;
    const auto add_factor = [&](stage_factor f, const tableaux::rational& by) {
        const std::size_t number = factor(f);
        if (factors_[number].support != 0)
            detail::add_to(sum, keep({std::vector<int>(method_.nodes.size(), 0), {number}, 0}), by);
    };
    for (const auto& [w, a] : x) {
        std::size_t node = 0;
        int k = 0;
        if (!is_power(w, matrix, node, k)) {
            add_factor({matrix, 0, 0, w, 0}, a);
            continue;
        }
        const tableaux::rational part = a / tableaux::rational(k + 1);
        detail::add_to(sum, power(node, k + 1), part);
        add_factor({matrix, node, k + 1, 0, 0}, part);
    }
    return sum;
}

STAGECRAFT_INLINE std::size_t stage_words::row(std::size_t u, std::size_t left, std::size_t matrix) {
    const auto [place, is_new] = row_numbers_.try_emplace({u, left, matrix}, rows_.size());
    if (!is_new) return place->second;
    row_word r{false, u, left, matrix, 0};
    const stage_set from = rows_[u].support & words_[left].support;
    for (std::size_t i = 0; i < method_.A[matrix].size(); ++i)
        if ((from & detail::bit(i)) != 0) r.support |= detail::nonzeros(method_.A[matrix][i]);
    rows_.push_back(r);
    return rows_.size() - 1;
}

}  // namespace stagecraft::theory
