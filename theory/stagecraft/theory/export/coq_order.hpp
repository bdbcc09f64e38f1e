// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <set>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <stagecraft/theory/export/coq_statement.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>
#include <stagecraft/theory/trees/tree_text.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stagecraft::theory::coq {

/// The order and a tree of the next order whose condition fails.
struct order_witness {
    int order = 0;
    std::string tree;   ///< in Coq
    std::string words;  ///< "dot(b, c*c*(A*c)) == 1/15"
};

/// Orders up to which an exported file goes through all trees.
inline constexpr int largest_order = 20;
/// Products of stage vectors that such a file may need: Coq compares each with all others of its order.
inline constexpr int largest_work = 8000;

/// How many products Coq's levels need up to order p, counted until they exceed largest_work.
inline int work(const coq_method& m, int p) {
    using level = std::vector<coq_method::element>;
    const auto once = [](level all) {
        std::set<std::string> seen;
        level out;
        for (auto& v : all) {
            std::string key;
            for (const auto& x : v) key += x.str() + ";";
            if (seen.insert(key).second) out.push_back(std::move(v));
        }
        return out;
    };
    std::vector<level> trees, grown;  // of 1, 2, ... nodes
    int products = 0;
    for (int n = 1; n <= p; ++n) {
        level all;
        if (n == 1) all.push_back(m.one());
        for (int k = 1; k < n; ++k)
            for (const auto& t : trees[static_cast<std::size_t>(n - k - 1)])
                for (const auto& u : grown[static_cast<std::size_t>(k - 1)]) {
                    if (++products > largest_work) return products;
                    all.push_back(m.multiply(t, u));
                }
        trees.push_back(once(std::move(all)));
        level next;
        for (const auto& v : trees.back()) next.push_back(scale(m, tableaux::quadratic(n), m.apply(v)));
        grown.push_back(once(std::move(next)));
    }
    return products;
}

/// The order by the trees: of a family `known`, with the quadrature's failure as witness where it is one.
/// Throws std::invalid_argument where an exported file could not go through all trees.
inline order_witness order_of(const coq_method& m, std::optional<int> known = {}) {
    const auto refuse = [&m](int order) {
        throw std::invalid_argument(
            "coq: order " + std::to_string(order) +
            ": an exported proof goes through all trees up to order " + std::to_string(largest_order) +
            " and " + std::to_string(largest_work) + " products; beyond, B, C and D give the order" +
            (m.family.empty() ? "" : ": stagecraft certify " + m.family + " " + std::to_string(m.stages())));
    };
    if (known && *known > largest_order) refuse(*known);
    if (known) {
        auto power = m.one();
        for (int k = 0; k < *known; ++k) power = m.multiply(m.c(), power);
        const tableaux::quadratic residual = m.dot_b(power) * tableaux::quadratic(*known + 1) - 1;
        if (!(residual == 0)) {
            if (work(m, *known) > largest_work) refuse(*known);
            return {*known, bushy(*known + 1),
                    "b^T c^" + std::to_string(*known) + " == 1/" + std::to_string(*known + 1)};
        }
    }
    const auto found = theory::order_of(m, known ? std::min(*known + 1, largest_order)
                                                 : std::min(2 * m.stages() + 1, tableaux::largest_order));
    if (!found.is_exact()) refuse(found.order + 1);
    if (work(m, found.order) > largest_work) refuse(found.order);
    const auto& first = found.failing.front().tree;
    return {found.order, text(first), condition_text(first)};
}

/// The theorem on the order, `p` of whose trees the witness tells; and where a larger order is claimed, that it is not.
inline std::string order_theorem(const coq_method& m, const order_witness& w, std::optional<int> claimed) {
    const std::string p = std::to_string(w.order);
    std::string out = "(** Order " + p + ": the conditions of all trees of at most " + p +
                      " nodes hold, and that of one of " + std::to_string(w.order + 1) +
                      " nodes does not: " + comment(w.words) + ". *)\n";
    out += theorem(m, "order_of_the_method", "order_is", p, "order", p + " " + w.tree);
    if (claimed && *claimed > w.order) {
        const std::string q = std::to_string(*claimed);
        out += "(** So the order " + q + " that is claimed is refuted. *)\nTheorem order_" + q +
               "_is_refuted : " + about(m, "~ has_order", q) + ".\nProof.\n  " + introduced(m) +
               " apply order_is_refutes with (1 := " + applied(m, "order_of_the_method") +
               "). apply Nat.ltb_lt. reflexivity.\nQed.\n\n";
    }
    return out;
}

}  // namespace stagecraft::theory::coq
