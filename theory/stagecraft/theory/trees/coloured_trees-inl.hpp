// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/trees/coloured_trees.hpp"

#include "stagecraft/compiled.hpp"
#include "stagecraft/theory/trees/tree_weights.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE tree_table coupled_trees(tableaux::coupling c, bool uses_velocity, int partners,
                                           int max_order) {
    return tree_table(max_order, partners, admits_coupling{c, uses_velocity});
}

STAGECRAFT_INLINE unsigned colours_of(const tree_view& trees, std::uint32_t row) {
    const tree_row& t = trees.rows[row];
    const unsigned own = 1U << static_cast<unsigned>(t.colour);
    return t.order == 1 ? own : own | colours_of(trees, t.left) | colours_of(trees, t.right);
}

STAGECRAFT_INLINE std::string colour_suffix(bool nystrom, std::size_t partners, std::int32_t colour) {
    if (nystrom) return colour == 0 ? "_bar" : "";
    if (partners > 2) return "_" + std::to_string(colour + 1);
    return colour == 0 ? "" : "_hat";
}

STAGECRAFT_INLINE std::string coloured_text::condition(std::uint32_t row) const {
    const tree_row& t = trees_.rows[row];
    return "dot(b" + suffix(row) + ", " + vector(row).text + ") == " + (t.order == 1 ? "" : "1/") +
           std::to_string(t.density);
}

STAGECRAFT_INLINE std::string coloured_text::bracket(std::uint32_t row) const {
    const tree_row& t = trees_.rows[row];
    if (t.order == 1) return "tau" + suffix(row);
    std::string text;
    for (const std::uint32_t child : children(row)) text += (text.empty() ? "[" : ",") + bracket(child);
    return text + "]" + suffix(row);
}

STAGECRAFT_INLINE std::string coloured_text::suffix(std::uint32_t row) const {
    return colour_suffix(nystrom_, partners_, trees_.rows[row].colour);
}

STAGECRAFT_INLINE std::vector<std::uint32_t> coloured_text::children(std::uint32_t row) const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t r = row; trees_.rows[r].order > 1; r = trees_.rows[r].left)
        all.push_back(trees_.rows[r].right);
    return all;
}

STAGECRAFT_INLINE coloured_text::written coloured_text::vector(std::uint32_t row) const {
    const auto all = children(row);
    if (all.empty()) return {"one", true};
    if (nystrom_ && trees_.rows[row].colour == 0) return vector(all.front());
    std::string text;
    bool application = false;
    for (const std::uint32_t child : all) {
        const bool leaf = trees_.rows[child].order == 1;
        const written inside = leaf ? written{} : vector(child);
        std::string factor =
            leaf ? (nystrom_ && trees_.rows[child].colour == 0 ? "c" : "c" + suffix(child))
                 : "A" + suffix(child) + "*" + (inside.is_atom ? inside.text : "(" + inside.text + ")");
        application = !leaf;
        if (!leaf && all.size() > 1) factor = "(" + factor + ")";
        text += (text.empty() ? "" : "*") + factor;
    }
    return {text, all.size() == 1 && !application};
}

}  // namespace stagecraft::theory
