// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/existence/order_system.hpp"

#include <algorithm>
#include <bit>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/time_share.hpp"
#include "stagecraft/theory/statements/certainty.hpp"

namespace stagecraft::theory {

namespace detail {

/// The numbers as they are written, four times as uncertain as their digits say: some are cut off.
STAGECRAFT_INLINE std::vector<tableaux::ball> written_numbers(const sought_method& m) {
    std::vector<tableaux::ball> all;
    for (const sought_number& x : m.numbers) {
        const tableaux::rational r = x.radius * tableaux::rational(4);
        all.push_back(x.surd ? to_ball(tableaux::to_range(*x.surd)) : to_ball({x.value - r, x.value + r}));
    }
    return all;
}

/// A residual known more coarsely tells nothing.
inline constexpr tableaux::bound coarse = 1e-5L;

}  // namespace detail

STAGECRAFT_INLINE order_system::order_system(const sought_method& method, const tree_view& trees,
                                             const order_goal& goal)
    : method_(method),
      most_stages_(goal.most_stages),
      words_(method_, [this](std::size_t n, std::size_t m, int k) { return failing_rows(n, m, k); }),
      written_(method_, words_, detail::written_numbers(method_)) {
    for (std::size_t n = 0; n < method_.partners(); ++n) failing_rows(n, method_.node_of[n], 1);
    const int most = *std::max_element(goal.orders.begin(), goal.orders.end());
    std::vector<word_sum> stages, branches;  // g and A g of the trees
    for (std::uint32_t i = 0; i < trees.rows.size() && trees.rows[i].order <= most; ++i) {
        tableaux::time_share::check_now();
        const tree_row& t = trees.rows[i];
        word_sum g{{words_.one(), tableaux::rational(1)}};
        if (t.order > 1) g = words_.multiply(stages[t.left], branches[t.right]);
        const auto colour = static_cast<std::size_t>(t.colour);
        for (std::size_t k = colour; k < method_.weights.size(); k += method_.partners()) {
            if (t.order > goal.orders[k / method_.partners()]) continue;
            word_sum form;
            for (const auto& [word, by] : g)
                for (const auto& [w, x] : reduced(k, word)) detail::add_to(form, w, by * x);
            require(k, std::move(form), tableaux::rational(1) / tableaux::rational(t.density));
        }
        if (t.order == most) continue;
        branches.push_back(words_.apply(colour, g));
        stages.push_back(std::move(g));
    }
    if (method_.nodes.size() == 1)
        for (std::size_t w = 0; w < method_.weights.size(); ++w)
            for (std::size_t n = 0; n < method_.partners(); ++n)
                for (int k = 1, order = goal.orders[w / method_.partners()]; k < order; ++k)
                    drop_adjoint_syzygies(w, n, k, order);
    for (auto& [pivot, e] : by_pivot_) equations_.push_back(std::move(e));
    by_pivot_.clear();
}

STAGECRAFT_INLINE bool order_system::holds(const tableaux::ball& residual) {
    if (certainly_nonzero(residual)) {
        gap_.fails = std::min(gap_.fails, residual.magnitude());
        return false;
    }
    if (residual.radius() > detail::coarse) {
        gap_.open = true;
        return false;
    }
    gap_.holds = std::max(gap_.holds, residual.magnitude());
    return true;
}

STAGECRAFT_INLINE void order_system::impose(order_equation e) {
    if (imposed_.insert(key(e)).second) equations_.push_back(std::move(e));
}

STAGECRAFT_INLINE stage_set order_system::failing_rows(std::size_t matrix, std::size_t node, int k) {
    const auto known = failing_.find({matrix, node, k});
    if (known != failing_.end()) return known->second;
    stage_set failing = 0;
    const bool needed = k == 1 && node == method_.node_of[matrix];
    if (k > most_stages_) failing = detail::all_stages(method_.stages);
    for (std::size_t i = 0; i < static_cast<std::size_t>(method_.stages) && k <= most_stages_; ++i) {
        if (holds(written_.defect(matrix, node, k, i))) continue;
        if (needed)
            throw tableaux::undecided(
                gap_.open
                    ? "row " + std::to_string(i + 1) +
                          " of A: its entries have too few digits to tell which identities they are meant to "
                          "satisfy, its sum for a node among them; more digits, or fractions, tell it"
                    : "the sum of row " + std::to_string(i + 1) +
                          " of A is not its node: existence is looked at where it is");
        failing |= detail::bit(i);
    }
    bool of_use =
        needed;  // where rows with weights fail no weights vanish on the defect, and the conditions say all
    for (std::size_t w = 0; w < method_.weights.size(); ++w)
        of_use = of_use || (failing & words_.rows()[w].support) == 0;
    if (!of_use) failing = detail::all_stages(method_.stages);
    for (std::size_t i = 0; i < static_cast<std::size_t>(method_.stages); ++i) {
        if ((failing & detail::bit(i)) != 0) continue;
        order_equation e;
        e.matrix = matrix;
        e.node = node;
        e.k = k;
        e.index = i;
        impose(std::move(e));
    }
    failing_[{matrix, node, k}] = failing;
    return failing;
}

/// Whether row and word are orthogonal by zeros, or because a row vanishes in the columns that a part of the word has.
STAGECRAFT_INLINE bool order_system::annihilated(std::size_t row, std::size_t word) {
    const stage_set meet = words_.rows()[row].support & words_.words()[word].support;
    if (meet == 0) return true;
    if (words_.words()[word].factors.empty()) return false;
    const auto known = annihilated_.find({row, word});
    if (known != annihilated_.end()) return known->second;
    const auto vanishes = [&] {
        for (std::size_t j = 0; j < static_cast<std::size_t>(method_.stages); ++j)
            if ((meet & detail::bit(j)) != 0 && !holds(written_.row(row)[j])) return false;
        return true;
    };
    const bool is_weights = words_.rows()[row].is_weights;
    bool here = !is_weights && std::popcount(meet) <= 2 && vanishes(), found = here;
    const auto factors = words_.words()[word].factors;
    for (const std::size_t f : factors) {
        if (found) break;
        const stage_factor factor = words_.factors()[f];
        if (factor.k > 0) continue;
        const std::size_t rest = words_.without(word, f);
        if (annihilated(words_.row(row, rest, factor.matrix), factor.inside)) {
            found = true;
            break;
        }
    }
    if (!found && !is_weights) found = here = vanishes();
    for (std::size_t j = 0; here && j < static_cast<std::size_t>(method_.stages); ++j) {
        if ((meet & detail::bit(j)) == 0) continue;
        order_equation e;
        e.is = order_equation::kind::row;
        e.row = row;
        e.index = j;
        impose(std::move(e));
    }
    annihilated_[{row, word}] = found;
    return found;
}

STAGECRAFT_INLINE bool order_system::holds_adjoint(std::size_t weights, std::size_t matrix, int k,
                                                   stage_set columns) {
    if (method_.nodes.size() > 1) return false;
    for (std::size_t j = 0; j < static_cast<std::size_t>(method_.stages); ++j)
        if ((columns & detail::bit(j)) != 0 && !holds(written_.adjoint_defect(weights, matrix, 0, k, j)))
            return false;
    for (std::size_t j = 0; j < static_cast<std::size_t>(method_.stages); ++j)
        if ((columns & detail::bit(j)) != 0) impose(adjoint_equation(weights, matrix, k, j));
    return true;
}

/// w^T c^(k-1) A v = w^T (1 - c^k) v / k, where D(k) holds in the columns that v has.
STAGECRAFT_INLINE bool order_system::by_adjoint(std::size_t weights, std::size_t word, word_sum& out) {
    const stage_word w = words_.words()[word];
    if (method_.nodes.size() > 1 || w.factors.size() != 1) return false;
    const stage_factor f = words_.factors()[w.factors.front()];
    const int k = w.powers.front() + 1;
    const std::size_t inside = f.k > 0 ? words_.power(0, f.k - 1) : f.inside;
    if (!holds_adjoint(weights, f.matrix, k, words_.words()[inside].support)) return false;
    const tableaux::rational by = tableaux::rational(f.k > 0 ? f.k : 1) / tableaux::rational(k);
    const auto add = [&](std::size_t v, const tableaux::rational& x) {
        for (const auto& [u, y] : reduced(weights, v)) detail::add_to(out, u, x * y);
    };
    add(inside, by);
    add(words_.product(inside, words_.power(0, k)), -by);
    if (f.k > 0)
        add(words_.power(0, f.k + k - 1), tableaux::rational(-1));  // of the defect k A c^(k-1) - c^k
    return true;
}

STAGECRAFT_INLINE word_sum order_system::reduced(std::size_t weights, std::size_t word) {
    if ((words_.rows()[weights].support & words_.words()[word].support) == 0) return {};
    word_sum out;
    if (by_adjoint(weights, word, out)) return out;
    if (annihilated(weights, word)) return {};
    return {{word, tableaux::rational(1)}};
}

STAGECRAFT_INLINE void order_system::require(std::size_t weights, word_sum form, tableaux::rational right) {
    while (!form.empty()) {
        const auto [word, by] = *form.rbegin();
        const auto found = by_pivot_.find({weights, word});
        if (found == by_pivot_.end()) {
            order_equation e;
            e.is = order_equation::kind::weights;
            e.row = weights;
            for (auto& [w, x] : form) x /= by;
            e.words = std::move(form);
            e.right = right / by;
            by_pivot_.emplace(std::pair(weights, word), std::move(e));
            return;
        }
        right -= by * found->second.right;
        for (const auto& [w, x] : found->second.words) detail::add_to(form, w, -by * x);
    }
    if (right != 0)
        throw tableaux::undecided("the conditions contradict what holds of the table up to rounding");
}

/// D(k) in a column; where the weight of the stage is zero, that a row vanishes there.
STAGECRAFT_INLINE order_equation order_system::adjoint_equation(std::size_t weights, std::size_t matrix,
                                                                int k, std::size_t column) {
    order_equation e;
    e.index = column;
    if (method_.weights[weights][column] == 0) {
        e.is = order_equation::kind::row;
        e.row = words_.row(weights, words_.power(0, k - 1), matrix);
        return e;
    }
    e.is = order_equation::kind::adjoint;
    e.row = weights;
    e.matrix = matrix;
    e.k = k;
    return e;
}

/// D(k) is 0 = 0 in this column.
STAGECRAFT_INLINE bool order_system::trivial_adjoint(std::size_t weights, std::size_t matrix,
                                                     std::size_t column) const {
    for (std::size_t i = 0; i < static_cast<std::size_t>(method_.stages); ++i)
        if (method_.A[matrix][i][column] != 0 && method_.weights[weights][i] != 0) return false;
    const auto& c = method_.numbers[method_.nodes[0][column]];
    return method_.weights[weights][column] == 0 || (c.known && c.value == tableaux::rational(1));
}

/// Of D(k) in all columns, sum_j c_j^(l-1) D_j = 0 where C(l) holds in the rows that have weights, and B(l), B(k+l) follow
/// from the order: of so many columns with different nodes D_j = 0 follows (Vandermonde). Where a column with c_j = 0 is
/// missing, l begins with 2.
STAGECRAFT_INLINE void order_system::drop_adjoint_syzygies(std::size_t w, std::size_t n, int k, int order) {
    const auto& c = method_.nodes[0];
    std::vector<std::size_t> candidates;
    int first = 1;
    for (std::size_t j = static_cast<std::size_t>(method_.stages); j-- > 0;) {
        if (trivial_adjoint(w, n, j)) continue;
        const auto e = adjoint_equation(w, n, k, j);
        if (imposed_.contains(key(e))) {
            if (e.is == order_equation::kind::adjoint) candidates.push_back(j);
        } else if (c[j] == 0) {
            first = 2;
        } else {
            return;
        }
    }
    int most = 0;
    for (int l = 1; k + l <= order && (failing_rows(n, 0, l) & words_.rows()[w].support) == 0; ++l) most = l;
    std::vector<std::size_t> dropped;
    for (const std::size_t j : candidates) {
        if (static_cast<int>(dropped.size()) > most - first) break;
        bool differs = first == 1 || c[j] != 0;
        for (const std::size_t d : dropped)
            differs = differs && certainly_nonzero(written_.number(c[d]) - written_.number(c[j]));
        if (!differs) continue;
        for (const std::size_t d : dropped) distinct_.insert({c[d], c[j]});
        if (first == 2) distinct_.insert({0, c[j]});
        dropped.push_back(j);
    }
    for (const std::size_t j : dropped) {
        const auto gone = key(adjoint_equation(w, n, k, j));
        std::erase_if(equations_, [&](const order_equation& e) { return key(e) == gone; });
    }
}

STAGECRAFT_INLINE std::string order_system::row_name(std::size_t row) const {
    const row_word& r = words_.rows()[row];
    const auto numbered = [&](const std::string& letter, std::size_t n) {
        return method_.partners() == 1 ? letter : letter + "_" + std::to_string(n + 1);
    };
    if (r.is_weights)
        return numbered(r.of < method_.partners() ? "b" : "b_embedded", r.of % method_.partners()) + "^T";
    std::string text = row_name(r.of);
    const stage_word& left = words_.words()[r.left];
    for (std::size_t m = 0; m < left.powers.size(); ++m)
        if (left.powers[m] > 0)
            text += " C" + (method_.nodes.size() == 1 ? "" : "_" + std::to_string(m + 1)) +
                    (left.powers[m] == 1 ? "" : "^" + std::to_string(left.powers[m]));
    if (!left.factors.empty()) text += " diag(...)";
    return text + " " + numbered("A", r.matrix);
}

/// "C^2 A C e", with e for 1 and q5 for the defect of C(5).
STAGECRAFT_INLINE std::string order_system::word_name(std::size_t word) const {
    const stage_word& w = words_.words()[word];
    const auto numbered = [](const std::string& letter, bool alone, std::size_t n) {
        return alone ? letter : letter + "_" + std::to_string(n + 1);
    };
    std::string text;
    const auto add = [&](const std::string& factor) { text += (text.empty() ? "" : "*") + factor; };
    for (std::size_t m = 0; m < w.powers.size(); ++m)
        if (w.powers[m] > 0)
            add(numbered("c", w.powers.size() == 1, m) +
                (w.powers[m] == 1 ? "" : "^" + std::to_string(w.powers[m])));
    for (const std::size_t f : w.factors) {
        const stage_factor& factor = words_.factors()[f];
        const std::string A = numbered("A", method_.partners() == 1, factor.matrix);
        if (factor.k > 0)
            add("(" + std::to_string(factor.k) + "*" + A + "*c^" + std::to_string(factor.k - 1) + " - c^" +
                std::to_string(factor.k) + ")");
        else
            add("(" + A + "*" + word_name(factor.inside) + ")");
    }
    return text.empty() ? "1" : text;
}

STAGECRAFT_INLINE std::string order_system::name(const order_equation& e) const {
    const std::string of =
        method_.partners() > 1 ? " of tableau " + std::to_string(e.matrix + 1) : std::string();
    const std::string index = std::to_string(e.index + 1);
    switch (e.is) {
        case order_equation::kind::stage:
            return "C(" + std::to_string(e.k) + ") in row " + index + of;
        case order_equation::kind::adjoint:
            return "D(" + std::to_string(e.k) + ") in column " + index + of;
        case order_equation::kind::row:
            return row_name(e.row) + " is zero in column " + index;
        default:
            return "a condition on " + row_name(e.row) + " " + word_name(e.words.rbegin()->first);
    }
}

}  // namespace stagecraft::theory
