// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/trees/tree_text.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

namespace detail {

// Children with multiplicities, the smallest first, as the field writes them: c before A c.
STAGECRAFT_INLINE std::vector<std::pair<rooted_tree, int>> grouped_children(const rooted_tree& t) {
    std::vector<std::pair<rooted_tree, int>> groups;
    const auto all = children(t);
    for (auto child = all.rbegin(); child != all.rend(); ++child)
        if (groups.empty() || groups.back().first != *child)
            groups.emplace_back(*child, 1);
        else
            ++groups.back().second;
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& a, const auto& b) { return order(a.first) < order(b.first); });
    return groups;
}

STAGECRAFT_INLINE std::string index_letter(int depth) {
    return depth < 18 ? std::string(1, static_cast<char>('i' + depth)) : "i_{" + std::to_string(depth) + "}";
}

STAGECRAFT_INLINE std::string latex_power(const std::string& base, int exponent) {
    return exponent == 1 ? base : base + "^{" + std::to_string(exponent) + "}";
}

STAGECRAFT_INLINE written stage_vector_text(const rooted_tree& t) {
    std::vector<std::string> powers;   // what may stand on the left of a product
    std::vector<std::string> applied;  // bare applications of A, which go last
    for (const auto& [child, m] : grouped_children(t)) {
        const bool is_c = order(child) == 1;
        const written inside = stage_vector_text(child);
        const std::string factor =
            is_c ? "c" : "A*" + (inside.is_atom ? inside.text : "(" + inside.text + ")");
        if (is_c && m <= 2) {
            powers.insert(powers.end(), static_cast<std::size_t>(m), factor);
        } else if (m > 1) {
            powers.push_back("pow<" + std::to_string(m) + ">(" + factor + ")");
        } else {
            applied.push_back(factor);
        }
    }
    if (powers.empty() && applied.empty()) return {"one", true};
    if (powers.empty() && applied.size() == 1) return {applied[0], false};
    if (powers.size() == 1 && applied.empty()) return {powers[0], true};
    std::string text;
    for (const auto& p : powers) text += (text.empty() ? "" : "*") + p;
    for (const auto& a : applied) text += (text.empty() ? "(" : "*(") + a + ")";
    return {text, false};
}

STAGECRAFT_INLINE std::string stage_vector_latex(const rooted_tree& t, int depth) {
    const std::string i = index_letter(depth), j = index_letter(depth + 1);
    const auto groups = grouped_children(t);
    std::string text;
    for (const auto& [child, m] : groups) {
        if (order(child) == 1) {
            text.append(" ").append(latex_power("c_{" + i + "}", m));
        } else {
            const std::string sum =
                "\\sum_{" + j + "} a_{" + i + j + "}" + stage_vector_latex(child, depth + 1);
            const bool is_last = m == 1 && child == groups.back().first;  // a sum reaches to the end
            text.append(" ").append(is_last ? sum : latex_power("\\bigl(" + sum + "\\bigr)", m));
        }
    }
    return text;
}

}  // namespace detail

STAGECRAFT_INLINE std::string bracket(const rooted_tree& t) {
    if (order(t) == 1) return "tau";
    std::string text;
    for (const auto& [child, m] : detail::grouped_children(t))
        for (int k = 0; k < m; ++k) text.append(text.empty() ? "[" : ",").append(bracket(child));
    return text + "]";
}

STAGECRAFT_INLINE std::string bracket_latex(const rooted_tree& t) {
    if (order(t) == 1) return "\\tau";
    std::string text;
    for (const auto& [child, m] : detail::grouped_children(t))
        text.append(text.empty() ? "[" : ",").append(detail::latex_power(bracket_latex(child), m));
    return text + "]";
}

STAGECRAFT_INLINE rooted_tree tree_from_bracket(std::string_view text) {
    const auto fail = [&]() -> rooted_tree {
        throw std::invalid_argument("bracket: \"" + std::string(text) +
                                    "\" is not a rooted tree of 1 to 20 vertices");
    };
    std::vector<int> levels;
    int depth = 1;
    bool operand = true;  // whether a tree must come next
    for (std::size_t i = 0; i < text.size();) {
        if (levels.size() > static_cast<std::size_t>(rooted_tree::max_order) || depth < 1) return fail();
        if (operand && text.substr(i, 3) == "tau") {
            levels.push_back(depth);
            operand = false;
            i += 3;
            continue;
        }
        const char ch = text[i++];
        if (operand && ch == '[') {
            levels.push_back(depth++);
        } else if (!operand && ch == ',' && depth > 1) {
            operand = true;
        } else if (!operand && ch == ']' && depth > 1) {
            --depth;
        } else {
            return fail();
        }
    }
    if (operand || depth != 1 || levels.size() > static_cast<std::size_t>(rooted_tree::max_order))
        return fail();
    return rooted_tree(std::span<const int>(levels));
}

STAGECRAFT_INLINE std::string elementary_weight_text(const rooted_tree& t) {
    return "dot(b, " + detail::stage_vector_text(t).text + ")";
}

STAGECRAFT_INLINE std::string condition_text(const rooted_tree& t) {
    return elementary_weight_text(t) + " == " + (order(t) == 1 ? "" : "1/") + std::to_string(density(t));
}

STAGECRAFT_INLINE std::string condition_latex(const rooted_tree& t) {
    return "\\sum_{i} b_{i}" + detail::stage_vector_latex(t, 0) + " = " +
           (order(t) == 1 ? "1" : "\\frac{1}{" + std::to_string(density(t)) + "}");
}

}  // namespace stagecraft::theory
