// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <stagecraft/theory/existence/stage_words.hpp>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// Words and rows as vectors over K, for given values of the numbers; each is computed once. `method` and `words` must outlive
/// it; words may be added meanwhile.
template <class K>
class word_values {
  public:
    using vector = std::vector<K>;

    word_values(const sought_method& method, const stage_words& words, std::vector<K> numbers)
        : method_(method), words_(words), numbers_(std::move(numbers)) {}

    const K& number(std::size_t i) const { return numbers_[i]; }

    /// k (A c^(k-1))_i - c_i^k.
    K defect(std::size_t matrix, std::size_t node, int k, std::size_t i) const {
        const auto& c = method_.nodes[node];
        K sum(0);
        for (std::size_t j = 0; j < c.size(); ++j)
            if (method_.A[matrix][i][j] != 0 && (k == 1 || c[j] != 0))
                sum = sum + numbers_[method_.A[matrix][i][j]] * power(c[j], k - 1);
        return K(k) * sum - power(c[i], k);
    }
    /// k sum_i w_i c_i^(k-1) a_ij - w_j (1 - c_j^k): of D(k).
    K adjoint_defect(std::size_t weights, std::size_t matrix, std::size_t node, int k, std::size_t j) const {
        const auto& w = method_.weights[weights];
        const auto& c = method_.nodes[node];
        K sum(0);
        for (std::size_t i = 0; i < c.size(); ++i)
            if (w[i] != 0 && method_.A[matrix][i][j] != 0 && (k == 1 || c[i] != 0))
                sum = sum + numbers_[w[i]] * power(c[i], k - 1) * numbers_[method_.A[matrix][i][j]];
        if (w[j] == 0) return K(k) * sum;
        return K(k) * sum - numbers_[w[j]] * (K(1) - power(c[j], k));
    }

    const vector& word(std::size_t number) {
        if (word_.size() <= number) word_.resize(number + 1);
        if (!word_[number]) {
            const stage_word w = words_.words()[number];
            vector v(static_cast<std::size_t>(method_.stages), K(0));
            for (const std::size_t f : w.factors) factor(f);  // before references into factor_
            for (std::size_t i = 0; i < v.size(); ++i) {
                if ((w.support >> i & 1) == 0) continue;
                K x(1);
                bool first = true;
                const auto times = [&](const K& y) {
                    x = first ? y : x * y;
                    first = false;
                };
                for (std::size_t m = 0; m < w.powers.size(); ++m)
                    if (w.powers[m] > 0) times(power(method_.nodes[m][i], w.powers[m]));
                for (const std::size_t f : w.factors) times((*factor_[f])[i]);
                v[i] = x;
            }
            if (word_.size() <= number) word_.resize(number + 1);
            word_[number] = std::move(v);
        }
        return *word_[number];
    }

    const vector& row(std::size_t number) {
        if (row_.size() <= number) row_.resize(words_.rows().size());
        if (!row_[number]) {
            const row_word r = words_.rows()[number];
            vector v(static_cast<std::size_t>(method_.stages), K(0));
            if (r.is_weights) {
                for (std::size_t i = 0; i < v.size(); ++i) v[i] = numbers_[method_.weights[r.of][i]];
            } else {
                const vector left = word(r.left), u = row(r.of);
                const stage_set from = words_.rows()[r.of].support & words_.words()[r.left].support;
                for (std::size_t i = 0; i < v.size(); ++i) {
                    if ((from >> i & 1) == 0) continue;
                    const K x = r.left == 0 ? u[i] : u[i] * left[i];
                    for (std::size_t j = 0; j < v.size(); ++j)
                        if (method_.A[r.matrix][i][j] != 0)
                            v[j] = v[j] + x * numbers_[method_.A[r.matrix][i][j]];
                }
            }
            row_[number] = std::move(v);
        }
        return *row_[number];
    }

    /// sum_i w_i v_i.
    K weighted(std::size_t weights, std::size_t number) {
        const vector& v = word(number);
        const stage_set both = words_.rows()[weights].support & words_.words()[number].support;
        K sum(0);
        for (std::size_t i = 0; i < v.size(); ++i)
            if ((both >> i & 1) != 0)
                sum = sum + (number == 0 ? numbers_[method_.weights[weights][i]]
                                         : numbers_[method_.weights[weights][i]] * v[i]);
        return sum;
    }

  private:
    K power(std::size_t number, int k) const {
        K x(1);
        for (int n = 0; n < k; ++n) x = n == 0 ? numbers_[number] : x * numbers_[number];
        return x;
    }
    void factor(std::size_t number) {
        if (factor_.size() <= number) factor_.resize(number + 1);
        if (factor_[number]) return;
        const stage_factor f = words_.factors()[number];
        vector v(static_cast<std::size_t>(method_.stages), K(0));
        for (std::size_t i = 0; i < v.size(); ++i) {
            if ((f.support >> i & 1) == 0) continue;
            if (f.k > 0) {
                v[i] = defect(f.matrix, f.node, f.k, i);
                continue;
            }
            const vector& inside = word(f.inside);
            const stage_set from = words_.words()[f.inside].support;
            for (std::size_t j = 0; j < v.size(); ++j)
                if ((from >> j & 1) != 0 && method_.A[f.matrix][i][j] != 0)
                    v[i] = v[i] + numbers_[method_.A[f.matrix][i][j]] * inside[j];
        }
        if (factor_.size() <= number) factor_.resize(number + 1);
        factor_[number] = std::move(v);
    }

    const sought_method& method_;
    const stage_words& words_;
    std::vector<K> numbers_;
    std::vector<std::optional<vector>> word_, factor_, row_;
};

}  // namespace stagecraft::theory
