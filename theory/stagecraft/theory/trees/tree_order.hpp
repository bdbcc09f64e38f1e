// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/theory/trees/tree_weights.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// An order condition and its residual: elementary weight minus 1/gamma.
template <class K>
struct tree_residual {
    rooted_tree tree;
    K residual;
};

/// The criterion of exact arithmetic: a residual is not zero. It does not compile over rounded scalars.
struct not_zero {
    template <class K>
    constexpr bool operator()(const K& residual) const {
        static_assert(exact_scalar<K>, "over rounded scalars no computed residual proves an equality");
        return !(residual == K(0));
    }
};

/// Whether a residual certainly differs from zero. Exact fields decide it; scalars with `certainly_nonzero`
/// (enclosures) decide it by that. Floating-point scalars have no such criterion: pass one that says how much
/// rounding explains. A condition that does not certainly fail is not refuted, but not proved either.
struct certainly_fails {
    template <class K>
    constexpr bool operator()(const K& residual) const {
        if constexpr (exact_scalar<K>) {
            return !(residual == K(0));
        } else if constexpr (requires { certainly_nonzero(residual); }) {
            return certainly_nonzero(residual);
        } else {
            static_assert(
                !std::same_as<K, K>,
                "over floating scalars pass a criterion: a callable bool(const K& residual) that is "
                "true where the condition certainly fails");
            return false;
        }
    }
};

/// All conditions up to order `max_order`, in the order of the trees, with their residuals.
/// Throws std::invalid_argument for an order outside 1..20.
template <stage_algebra M>
std::vector<tree_residual<scalar_of<M>>> order_residuals(const M& model, int max_order) {
    const tree_table trees(max_order);
    tree_weights<M> walk(model, trees.view(), max_order);
    std::vector<tree_residual<scalar_of<M>>> all;
    all.reserve(trees.size());
    while (walk.advance())
        for (std::size_t i = 0; i < walk.weights().size(); ++i)
            all.push_back(
                {trees.view().tree(walk.first_row() + static_cast<std::uint32_t>(i)), walk.residual(i)});
    return all;
}

namespace detail {

// Appends the conditions of the walk's order that fail.
template <stage_algebra M, class Fails>
void append_failing(const tree_weights<M>& walk, const tree_view& trees, Fails fails,
                    std::vector<tree_residual<scalar_of<M>>>& failing) {
    for (std::size_t i = 0; i < walk.weights().size(); ++i) {
        if constexpr (exact_scalar<scalar_of<M>>)
            if (!not_zero{}(walk.defect(i))) continue;  // spares a division
        if (auto r = walk.residual(i); fails(r))
            failing.push_back({trees.tree(walk.first_row() + static_cast<std::uint32_t>(i)), std::move(r)});
    }
}

}  // namespace detail

/// The conditions up to order `max_order` that fail, with their residuals. `fails(residual)` decides, by
/// default `certainly_fails`. Throws std::invalid_argument for an order outside 1..20.
template <stage_algebra M, class Fails = certainly_fails>
std::vector<tree_residual<scalar_of<M>>> failing_conditions(const M& model, int max_order, Fails fails = {}) {
    const tree_table trees(max_order);
    tree_weights<M> walk(model, trees.view(), max_order);
    std::vector<tree_residual<scalar_of<M>>> failing;
    while (walk.advance()) detail::append_failing(walk, trees.view(), fails, failing);
    return failing;
}

/// Result of a search for the order: every condition of orders 1..order holds; `failing` are the failing
/// conditions of order `order` + 1, and it is empty where the search ended first (`order` is then only a
/// lower bound).
template <class K>
struct order_result {
    int order = 0;
    std::vector<tree_residual<K>> failing;

    bool is_exact() const { return !failing.empty(); }
};

/// The order of a method by its tree conditions, looked for up to `max_order`; it stops at the first order
/// with a failing condition. `fails` as in `failing_conditions`. A method with s stages and real nodes has
/// order at most 2s (Hairer-Norsett-Wanner I.II.7; lecture, Lemma 2.6), so `max_order` = 2s + 1 settles the
/// order. The conditions are those of autonomous systems; others need the row sums A 1 = c as well. Throws
/// std::invalid_argument for `max_order` outside 1..20.
template <stage_algebra M, class Fails = certainly_fails>
order_result<scalar_of<M>> order_of(const M& model, int max_order, Fails fails = {}) {
    if (max_order < 1 || max_order > rooted_tree::max_order)
        throw std::invalid_argument("max_order: outside 1..20");
    order_result<scalar_of<M>> result;
    // Tables grow three-fold per order: begin small, and begin again when the method turns out better.
    for (int reach = std::min(max_order, 6); result.failing.empty() && result.order < max_order;
         reach = std::min(max_order, reach + 4)) {
        const tree_table trees(reach);
        tree_weights<M> walk(model, trees.view(), reach);
        while (result.failing.empty() && walk.advance()) {
            if (walk.order() <= result.order) continue;
            detail::append_failing(walk, trees.view(), fails, result.failing);
            if (result.failing.empty()) result.order = walk.order();
        }
    }
    return result;
}

/// Whether all conditions up to order P hold exactly; `constexpr` for models that are.
template <int P, stage_algebra M>
constexpr bool has_order(const M& model) {
    constexpr fixed_tree_table<P> trees;
    tree_weights<M> walk(model, trees.view(), P);
    while (walk.advance())
        for (std::size_t i = 0; i < walk.weights().size(); ++i)
            if (not_zero{}(walk.defect(i))) return false;
    return true;
}

/// One term of the local error: h^n coefficient F(t)(y), F(t) the elementary differential;
/// coefficient = (elementary weight - 1/gamma) / sigma.
template <class K>
struct error_term {
    rooted_tree tree;
    K coefficient;
};

/// The local error terms of one order and the square of their 2-norm (a square, to stay inside exact fields).
template <class K>
struct error_terms {
    int order = 0;
    std::vector<error_term<K>> terms;
    K norm_squared{};
};

/// Error terms of order n, one for each tree, vanishing ones included; for n = p + 1 the principal ones
/// (Hairer-Norsett-Wanner I.II.3, Theorem 3.2; II.8 writes e(t) for the coefficient).
/// Throws std::invalid_argument for n outside 1..20.
template <stage_algebra M>
error_terms<scalar_of<M>> local_error_terms(const M& model, int n) {
    using K = scalar_of<M>;
    const tree_table trees(n);
    tree_weights<M> walk(model, trees.view(), n);
    while (walk.advance() && walk.order() < n) {
    }
    error_terms<K> result{n, {}, K(0)};
    for (std::size_t i = 0; i < walk.weights().size(); ++i) {
        const auto row = walk.first_row() + static_cast<std::uint32_t>(i);
        K e = walk.residual(i) / K(trees.view().rows[row].symmetry);
        result.norm_squared += e * e;
        result.terms.push_back({trees.view().tree(row), std::move(e)});
    }
    return result;
}

}  // namespace stagecraft::theory
