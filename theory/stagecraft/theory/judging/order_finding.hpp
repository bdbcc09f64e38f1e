// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stagecraft/tableau/order_conditions.hpp>
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

/// The order of one set of weights: `order` is the largest order no condition of which certainly fails;
/// `failing` the conditions of the next order that do, empty where the search ended first.
/// `residual` and `bound` are the largest over the conditions that hold (zero over exact fields).
template <class K>
struct order_finding {
    int order = 0;
    std::vector<tree_residual<K>> failing;
    tableaux::bound residual = 0;
    tableaux::bound bound = 0;
};

/// No method with s stages exceeds order 2s (lecture, Lemma 2.6), no explicit one order s
/// (Hairer-Norsett-Wanner I.II.5), because the tall tree's condition b^T A^{p-1} 1 = 1/p! fails.
template <class K>
int order_barrier(const subject<K>& s) {
    return s.strictly_lower ? s.stages() : 2 * s.stages();
}

/// Order conditions of autonomous systems for A and `weights`, up to order `most`.
template <class K, class Weights>
order_finding<K> find_order(const subject<K>& s, const Weights& weights, int most) {
    order_finding<K> found;
    const auto fails = [&](const K& residual) {
        if constexpr (requires { residual.radius(); }) {
            if (!certainly_nonzero(residual)) {
                found.residual = std::max(found.residual, residual.magnitude());
                found.bound = std::max(found.bound, residual.radius());
            }
        }
        return certainly_nonzero(residual);
    };
    auto result = order_of(matrix_model<K>(s.t, weights), most, fails);
    found.order = std::min(result.order, order_barrier(s));
    found.failing = std::move(result.failing);
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
    std::vector<simplifying_failure<K>> failing;
    tableaux::bound residual = 0;
    tableaux::bound bound = 0;
};

/// B(k): b^T c^{k-1} = 1/k and C(k): A c^{k-1} = c^k/k for k = 1, ..., most (Hairer-Wanner II, section IV.5),
/// up to the first k that certainly fails.
template <class K>
stage_order_finding<K> find_stage_order(const subject<K>& s, int most) {
    stage_order_finding<K> found;
    node_power<K> power(s.stages());
    int row = -1;
    const auto equal = [&](const K& left, const K& right) {
        const K residual = (left - right) / K(power.k());
        if (certainly_nonzero(residual)) {
            found.failing.push_back({row < 0 ? 'B' : 'C', power.k(), row, residual});
        } else if constexpr (requires { residual.radius(); }) {
            found.residual = std::max(found.residual, residual.magnitude());
            found.bound = std::max(found.bound, residual.radius());
        }
        ++row;
        return true;
    };
    for (; power.k() <= most; power.advance(s.t.c)) {
        row = -1;
        satisfies_quadrature(s.t, power, equal);
        satisfies_stages(s.t, power, equal);
        if (!found.failing.empty()) break;
        found.stage_order = power.k();
    }
    return found;
}

}  // namespace stagecraft::theory
