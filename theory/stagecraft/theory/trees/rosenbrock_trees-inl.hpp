// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/trees/rosenbrock_trees.hpp"

#include <algorithm>
#include <stdexcept>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE rosenbrock_trees::rosenbrock_trees(rosenbrock_conditions which, int max_level)
    : which_(which) {
    if (max_level < 1 || max_level > 10) throw std::invalid_argument("max_level: outside 1..10");
    for (int n = 1; n <= max_level; ++n) {
        std::vector<std::uint32_t> children;
        grow(n, false, n - 1, children);
        if (which == rosenbrock_conditions::any_matrix && n > 1) grow(n, true, n - 1, children);
        if (which == rosenbrock_conditions::index_1 && n > 1 && n < max_level) grow(n, true, n, children);
    }
}

STAGECRAFT_INLINE void rosenbrock_trees::append(bool fat, std::vector<std::uint32_t> children) {
    rosenbrock_tree t;
    t.fat = t.some_fat = fat;
    const bool counts = !fat || which_ == rosenbrock_conditions::any_matrix;
    t.order = counts ? 1 : 0;
    for (const std::uint32_t c : children) {
        t.order += rows_[c].order;
        t.density *= rows_[c].density;
        t.some_fat = t.some_fat || rows_[c].some_fat;
    }
    if (counts) t.density *= t.order;
    t.level = t.order + (counts ? 0 : 1);
    t.children = std::move(children);
    rows_.push_back(std::move(t));
}

/// Appends the trees of this order whose root has `children` and others, no larger, with `left` vertices together.
STAGECRAFT_INLINE void rosenbrock_trees::grow(int order, bool fat, int left,
                                              std::vector<std::uint32_t>& children) {
    const bool index_1 = which_ == rosenbrock_conditions::index_1;
    if (left == 0) {
        const bool only_child = children.size() == 1;
        if (fat && only_child == index_1) return;
        if (index_1 && only_child && rows_[children.front()].fat) return;
        return append(fat, children);
    }
    const auto last = children.empty() ? rows_.size() : children.back() + 1U;
    for (std::size_t k = 0; k < last && rows_[k].order <= left && rows_[k].order < order; ++k) {
        children.push_back(static_cast<std::uint32_t>(k));
        grow(order, fat, left - rows_[k].order, children);
        children.pop_back();
    }
}

STAGECRAFT_INLINE std::vector<std::uint32_t> rosenbrock_trees::of_level(int level) const {
    std::vector<std::uint32_t> all;
    for (std::size_t k = 0; k < rows_.size(); ++k)
        if (rows_[k].level == level) all.push_back(static_cast<std::uint32_t>(k));
    return all;
}

STAGECRAFT_INLINE std::string rosenbrock_trees::condition(std::uint32_t row) const {
    const rosenbrock_tree& t = rows_[row];
    const std::string value = is_zero(t) ? "0" : t.density == 1 ? "1" : "1/" + std::to_string(t.density);
    return "dot(b, " + vector(t).text + ") == " + value;
}

STAGECRAFT_INLINE std::string rosenbrock_trees::bracket(std::uint32_t row) const {
    const rosenbrock_tree& t = rows_[row];
    if (t.children.empty()) return "tau";
    std::string text;
    for (auto child = t.children.rbegin(); child != t.children.rend(); ++child)
        text += (text.empty() ? (t.fat ? "{" : "[") : ",") + bracket(*child);
    return text + (t.fat ? "}" : "]");
}

STAGECRAFT_INLINE rosenbrock_trees::written rosenbrock_trees::vector(const rosenbrock_tree& t) const {
    if (t.children.empty()) return {"one", true};
    const bool any_matrix = which_ == rosenbrock_conditions::any_matrix, single = t.children.size() == 1;
    const auto applied = [&](const char* matrix, std::uint32_t child) {
        const written inside = vector(rows_[child]);
        return matrix + ("*" + (inside.is_atom ? inside.text : "(" + inside.text + ")"));
    };
    if (any_matrix && t.fat) return {applied("Gamma", t.children.front()), false};
    if (!any_matrix && single) return {applied("beta", t.children.front()), false};
    std::string text;
    for (auto child = t.children.rbegin(); child != t.children.rend(); ++child) {
        const bool leaf = rows_[*child].children.empty();
        std::string factor = leaf ? "c" : applied("A", *child);
        if (!leaf && !single) factor = "(" + factor + ")";
        text += (text.empty() ? "" : "*") + factor;
    }
    if (t.fat) return {"omega*(" + text + ")", false};
    return {text, single && rows_[t.children.front()].children.empty()};
}

}  // namespace stagecraft::theory
