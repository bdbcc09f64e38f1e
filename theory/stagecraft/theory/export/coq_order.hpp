// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <optional>
#include <set>
#include <stagecraft/tableaux/tableau_file.hpp>
#include <stagecraft/theory/export/coq_statement.hpp>
#include <stagecraft/theory/models/legendre_simplifying.hpp>
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
    std::string shown;  ///< what Coq's rule is given: the order, of a family C and D, and the tree
    std::string words;  ///< "dot(b, c*c*(A*c)) == 1/15"
};

/// Products of stage vectors that an exported file of a table may need: Coq compares each with all others of its order.
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

/// The order of a table by the trees.
/// Throws std::invalid_argument where an exported file could not go through all of them.
inline order_witness order_by_trees(const coq_method& m) {
    const auto refuse = [](int order) {
        throw std::invalid_argument(
            "coq: order " + std::to_string(order) +
            ": an exported proof about a table goes through all trees, by at most " +
            std::to_string(largest_work) +
            " products; of a family (stagecraft certify gauss 12) B, C and D give the order");
    };
    const auto found = theory::order_of(m, std::min(2 * m.stages() + 1, tableaux::largest_order));
    if (!found.is_exact()) refuse(found.order + 1);
    if (work(m, found.order) > largest_work) refuse(found.order);
    const auto& first = found.failing.front().tree;
    return {found.order, std::to_string(found.order) + " " + text(first), condition_text(first)};
}

/// The order of a family's member by B, C and D, whose B(order + 1) fails.
inline order_witness order_by(const simplifying& known, int stages) {
    const int p = known.b;
    const auto at_most_stages = [stages](int n) { return std::to_string(std::min(n, stages)); };
    return {p,
            std::to_string(p) + " " + at_most_stages(known.c) + " " + at_most_stages(known.d) + " " +
                bushy(p + 1),
            "b^T c^" + std::to_string(p) + " == 1/" + std::to_string(p + 1)};
}

/// The theorem on the order; and where a larger order is claimed, that it is not.
inline std::string order_theorem(const coq_method& m, const order_witness& w, std::optional<int> claimed) {
    const std::string p = std::to_string(w.order);
    std::string out = "(** Order " + p + ": the conditions of all trees of at most " + p +
                      " nodes hold, and that of one of " + std::to_string(w.order + 1) +
                      " nodes does not: " + comment(w.words) + ". *)\n";
    out += theorem(m, "order_of_the_method", "order_is", p, "order", w.shown);
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
