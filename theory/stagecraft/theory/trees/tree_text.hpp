// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/method/rooted_tree.hpp>
#include <string>
#include <string_view>

namespace stagecraft::theory {

using stagecraft::rooted_tree;  // for who names theory's things only

namespace detail {

// The index of summation at a depth: i, j, k, ..., z, then numbered; sums are nested, so siblings may share.
std::string index_letter(int depth);

std::string latex_power(const std::string& base, int exponent);

// g(t) in the expression language, and whether it must be put in parentheses as a factor.
struct written {
    std::string text;
    bool is_atom;
};

}  // namespace detail

/// Bracket notation (Butcher): "tau" for the single vertex, "[t1,...,tm]" for the tree with these subtrees at
/// its root, the smallest first: "[tau,tau,[tau]]".
std::string bracket(const rooted_tree& t);

/// Bracket notation for LaTeX, repeated subtrees as powers: "[\tau^{2},[\tau]]".
std::string bracket_latex(const rooted_tree& t);

/// The tree with this bracket notation, subtrees in any order, no blanks: the inverse of `bracket`.
/// Throws std::invalid_argument for anything else, and for more than 20 vertices.
rooted_tree tree_from_bracket(std::string_view text);

/// The left-hand side of the order condition of t in the expression language (expression.hpp), where it
/// compiles as it stands: "dot(b, c*c*(A*c))".
std::string elementary_weight_text(const rooted_tree& t);

/// The order condition of t: "dot(b, c*c*(A*c)) == 1/15".
std::string condition_text(const rooted_tree& t);

/// The order condition of t in indices: "\sum_{i} b_{i} c_{i}^{2} \sum_{j} a_{ij} c_{j} = \frac{1}{15}".
std::string condition_latex(const rooted_tree& t);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/trees/tree_text-inl.hpp"
#endif
