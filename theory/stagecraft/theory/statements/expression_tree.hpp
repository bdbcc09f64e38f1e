// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/method/rooted_tree.hpp>
#include <stagecraft/theory/statements/expression.hpp>

namespace stagecraft::theory {

namespace detail {

// The rooted tree whose vector g(t) a stage vector is, under the row-sum convention c = A*one.
constexpr rooted_tree vector_tree(unit_vector) { return {}; }
constexpr rooted_tree vector_tree(node_vector) { return {1, 2}; }
template <class V>
constexpr rooted_tree vector_tree(application<V> e);
template <class U, class V>
constexpr rooted_tree vector_tree(product<U, V> e);
template <int N, class V>
constexpr rooted_tree vector_tree(power<N, V> e);

template <class V>
constexpr rooted_tree vector_tree(application<V> e) {
    return butcher_product(rooted_tree{}, vector_tree(e.argument));
}
template <class U, class V>
constexpr rooted_tree vector_tree(product<U, V> e) {
    return merge_roots(vector_tree(e.left), vector_tree(e.right));
}
template <int N, class V>
constexpr rooted_tree vector_tree(power<N, V> e) {
    rooted_tree r;
    for (int i = 0; i < N; ++i) r = merge_roots(r, vector_tree(e.base));
    return r;
}

// The tree of f^T v when v has the tree t: (b∘u)^T v = b^T (u v), (A^T f)^T v = f^T (A v).
constexpr rooted_tree row_tree(weight_row, const rooted_tree& t) { return t; }
template <class F, class V>
constexpr rooted_tree row_tree(weighted_row<F, V> e, const rooted_tree& t);
template <class F>
constexpr rooted_tree row_tree(transposed_application<F> e, const rooted_tree& t);

template <class F, class V>
constexpr rooted_tree row_tree(weighted_row<F, V> e, const rooted_tree& t) {
    return row_tree(e.row, merge_roots(vector_tree(e.by), t));
}
template <class F>
constexpr rooted_tree row_tree(transposed_application<F> e, const rooted_tree& t) {
    return row_tree(e.argument, butcher_product(rooted_tree{}, t));
}

// Which expressions have a tree, by shape.
template <class>
inline constexpr bool has_tree = false;
template <>
inline constexpr bool has_tree<unit_vector> = true;
template <>
inline constexpr bool has_tree<node_vector> = true;
template <>
inline constexpr bool has_tree<weight_row> = true;
template <class V>
inline constexpr bool has_tree<application<V>> = has_tree<V>;
template <class U, class V>
inline constexpr bool has_tree<product<U, V>> = has_tree<U>&& has_tree<V>;
template <int N, class V>
inline constexpr bool has_tree<power<N, V>> = has_tree<V>;
template <class F, class V>
inline constexpr bool has_tree<weighted_row<F, V>> = has_tree<F>&& has_tree<V>;
template <class F>
inline constexpr bool has_tree<transposed_application<F>> = has_tree<F>;
template <class F, class V>
inline constexpr bool has_tree<pairing<F, V>> = has_tree<F>&& has_tree<V>;

}  // namespace detail

/// Expressions that are the elementary weight of a rooted tree: dot(b, v) with v made of one, c, A, products
/// and powers, and its rewritings with weighted and transposed rows.
template <class E>
concept tree_expression = number_expression<E> && detail::has_tree<E>;

/// The rooted tree whose elementary weight the expression is, with c = A*one. Throws std::invalid_argument
/// (in constant expressions: does not compile) beyond 20 vertices.
template <expression E>
constexpr rooted_tree tree_of(const E& e) {
    static_assert(tree_expression<E>,
                  "only dot(b, ...) of one, c, A, products and powers is an elementary weight");
    return detail::row_tree(e.row, detail::vector_tree(e.vector));
}

/// Whether the equation is the order condition of a rooted tree: an elementary weight equal to 1/gamma.
template <class L, class R>
constexpr bool is_order_condition(const equation<L, R>& e) {
    if constexpr (tree_expression<L> && std::same_as<R, constant>)
        return e.right.value == exact_number(1, density(tree_of(e.left)));
    else
        return false;
}

}  // namespace stagecraft::theory
