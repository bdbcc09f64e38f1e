// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stagecraft/method/order_conditions.hpp>
#include <stagecraft/theory/judging/subject.hpp>
#include <stagecraft/theory/models/matrix_model.hpp>
#include <stagecraft/theory/statements/certainty.hpp>
#include <stagecraft/theory/trees/tree_order.hpp>
#include <utility>
#include <vector>

namespace stagecraft::theory {

/// Row sums minus nodes: (A*1 - c)_i.
template <class K>
std::vector<K> row_sum_defects(const subject<K>& s) {
    std::vector<K> defects;
    for (int i = 0; i < s.stages(); ++i) {
        K sum = s.t.A(i, 0);
        for (int j = 1; j < s.stages(); ++j) sum = sum + s.t.A(i, j);
        defects.push_back(sum - s.t.c(i));
    }
    return defects;
}

/// What the order conditions with at most n vertices leave, at most: residual and bound as they stand, and
/// both times the density, that is relative to the 1/gamma that each condition asks for.
struct condition_sizes {
    tableaux::bound residual = 0;
    tableaux::bound bound = 0;
    tableaux::bound relative_residual = 0;
    tableaux::bound relative_bound = 0;

    /// Takes in a condition that leaves `defect`/gamma.
    template <class K>
    void take(const K& defect, tableaux::bound gamma);
};

/// Residuals of conditions beyond this part of 1/gamma are no rounding errors, but a lower order.
inline constexpr tableaux::bound rounding_level = 1e-6L;

/// The order of one set of weights: `order` is the largest order no condition of which certainly fails;
/// `failing` the conditions of the next order that do, empty where the search ended first. Over enclosures
/// `tested` is the largest order up to which every bound is small enough to refute. `numerical` is the largest
/// order up to which no condition leaves more than `rounding_level` of its 1/gamma.
template <class Failure>
struct search_for_order {
    int order = 0;
    int tested = 0;
    int numerical = 0;
    std::vector<Failure> failing;
    std::vector<condition_sizes> sizes{1};  ///< sizes[n]: up to order n, as far as was looked

    const condition_sizes& up_to(int n) const {
        return sizes[std::min(static_cast<std::size_t>(n), sizes.size() - 1)];
    }
    /// Takes in order n, all conditions of which have been looked at: whether the search goes on.
    bool conclude(int n, const condition_sizes& size) {
        if (failing.empty()) order = n;
        if (order == n && tested == n - 1 && !says_nothing(size.relative_bound, 1)) tested = n;
        if (numerical == n - 1 && size.relative_residual <= rounding_level) numerical = n;
        sizes.push_back(size);
        return failing.empty() || numerical == n;
    }
};

template <class K>
using order_finding = search_for_order<tree_residual<K>>;

/// |x|: of an enclosure, of its middle.
template <class K>
tableaux::bound size_of(const K& x) {
    if constexpr (requires { x.radius(); })
        return x.magnitude();
    else if constexpr (exact_scalar<K>)
        return std::abs(x.template to<tableaux::bound>());
    else  // a residue has no size
        return certainly_nonzero(x) ? 1 : 0;
}
template <class K>
tableaux::bound uncertainty_of(const K& x) {
    if constexpr (requires { x.radius(); })
        return x.radius();
    else
        return 0;
}

template <class K>
void condition_sizes::take(const K& defect, tableaux::bound gamma) {
    const bool fails = certainly_nonzero(defect);
    if constexpr (exact_scalar<K>)
        if (!fails) return;
    const auto left = size_of(defect), bound_on_it = uncertainty_of(defect);
    relative_residual = std::max(relative_residual, left);
    residual = std::max(residual, left / gamma);
    if (fails) return;
    relative_bound = std::max(relative_bound, bound_on_it);
    bound = std::max(bound, bound_on_it / gamma);
}

/// No method with s stages exceeds order 2s (lecture, Lemma 2.6), no explicit one order s
/// (Hairer-Norsett-Wanner I.II.5), because the tall tree's condition b^T A^{p-1} 1 = 1/p! fails.
template <class K>
int order_barrier(const subject<K>& s) {
    return s.strictly_lower ? s.stages() : 2 * s.stages();
}

namespace detail {

/// Looks at the conditions of the walk's order: whether the search goes on.
template <class K>
bool look_at_order(const tree_weights<matrix_model<K>>& walk, const tree_view& trees,
                   order_finding<K>& found) {
    const int n = walk.order();
    condition_sizes size = found.sizes.back();
    const bool holds_so_far = found.failing.empty();
    for (std::size_t i = 0; i < walk.weights().size(); ++i) {
        const std::uint32_t row = walk.first_row() + static_cast<std::uint32_t>(i);
        const K defect = walk.defect(i);
        if (certainly_nonzero(defect) && holds_so_far)
            found.failing.push_back({trees.tree(row), walk.residual(i)});
        size.take(defect, static_cast<tableaux::bound>(trees.rows[row].density));
    }
    return found.conclude(n, size);
}

}  // namespace detail

/// Order conditions of autonomous systems for A and `weights`, up to order `most`. Stops at the first order
/// with a condition that fails by more than rounding.
template <class K, class Weights>
order_finding<K> find_order(const subject<K>& s, const Weights& weights, int most) {
    order_finding<K> found;
    const matrix_model<K> model(s.t, weights);
    bool go_on = most > 0;
    // Tables grow three-fold per order: begin small, and begin again when the method turns out better.
    for (int reach = std::min(most, 6); go_on; reach = std::min(most, reach + 4)) {
        const tree_table trees(reach);
        tree_weights<matrix_model<K>> walk(model, trees.view(), reach);
        while (go_on && walk.advance())
            if (walk.order() == static_cast<int>(found.sizes.size()))
                go_on = detail::look_at_order(walk, trees.view(), found);
        go_on = go_on && reach < most;
    }
    const int barrier = order_barrier(s);
    found.order = std::min(found.order, barrier);
    found.tested = std::min(found.tested, barrier);
    found.numerical = std::min(found.numerical, barrier);
    return found;
}

/// Where c = A*1 fails the conditions of non-autonomous systems are more than those of autonomous ones: they
/// are those of y' = f(t, y), t' = 1 with the stages' times c, so a leaf of a tree stands for A*1 or for c
/// (Hairer-Norsett-Wanner I.II.2, before Theorem 2.13, assumes c = A*1 to avoid this). The largest order up to
/// `most` of which no such condition certainly fails.
template <class K, class Weights>
int non_autonomous_order(const subject<K>& s, const Weights& weights, int most) {
    return order_by_trees(s.t, weights, most,
                          [](const K& left, const K& right) { return !certainly_nonzero(left - right); });
}

/// One simplifying condition, where it fails: B(k) has no row.
template <class K>
struct simplifying_failure {
    char which;  ///< 'B' or 'C'
    int k;
    int row;  ///< 0-based, -1 for B
    K residual;
};

/// What B(q) and C(q) leave: the failures of the first k with one, and the largest residual and bound of
/// those that hold (zero over exact fields).
template <class K>
struct stage_order_finding {
    int stage_order = 0;
    int tested = 0;  ///< as far as every bound is small enough to refute
    std::vector<simplifying_failure<K>> failing;
    tableaux::bound residual = 0;
    tableaux::bound bound = 0;
    tableaux::bound relative_bound = 0;  ///< to 1/k for B, to the largest c_i^k/k for C
};

/// B(k): b^T c^{k-1} = 1/k and C(k): A c^{k-1} = c^k/k for k = 1, ..., most (Hairer-Wanner II, section IV.5),
/// up to the first k that certainly fails.
template <class K>
stage_order_finding<K> find_stage_order(const subject<K>& s, int most) {
    stage_order_finding<K> found;
    node_power<K> power(s.stages());
    int row = -1;
    tableaux::bound largest = 0, scale = 1;
    for (int i = 0; i < s.stages(); ++i) largest = std::max(largest, size_of(K(s.t.c(i))));
    const auto equal = [&](const K& left, const K& right) {
        const K residual = (left - right) / K(power.k());
        if (certainly_nonzero(residual)) {
            found.failing.push_back({row < 0 ? 'B' : 'C', power.k(), row, residual});
        } else if constexpr (requires { residual.radius(); }) {
            found.residual = std::max(found.residual, residual.magnitude());
            found.bound = std::max(found.bound, residual.radius());
            if (residual.radius() > 0)
                found.relative_bound = std::max(
                    found.relative_bound,
                    residual.radius() * static_cast<tableaux::bound>(power.k()) / (row < 0 ? 1 : scale));
        }
        ++row;
        return true;
    };
    for (; power.k() <= most; power.advance(s.t.c)) {
        row = -1;
        scale *= largest;
        satisfies_quadrature(s.t, power, equal);
        satisfies_stages(s.t, power, equal);
        if (!found.failing.empty()) break;
        found.stage_order = power.k();
        if (found.tested == power.k() - 1 && !says_nothing(found.relative_bound, 1)) found.tested = power.k();
    }
    return found;
}

}  // namespace stagecraft::theory
