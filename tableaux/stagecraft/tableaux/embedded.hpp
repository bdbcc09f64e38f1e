// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/simplifying.hpp"

namespace stagecraft::tableaux {

namespace detail {

/// What one rooted tree asks of the weights: b^T stages = 1/density.
template <class K>
struct weight_condition {
    column<K> stages;
    K density;
    int order = 1;
};

/// The conditions of all rooted trees up to `order`: a tree is a root over a multiset of smaller trees, its
/// stage vector the product of A times theirs, its density its order times theirs.
template <class K>
std::vector<weight_condition<K>> weight_conditions(const stagecraft::tableau<K>& t, int order) {
    const auto s = t.b.size();
    std::vector<weight_condition<K>> trees;  // by order
    std::vector<column<K>> branches;         // A times the stages of trees[k]
    for (int n = 1; n <= order; ++n) {
        const std::size_t begin = trees.size();
        std::vector<weight_condition<K>> grown;
        const auto grow = [&](auto self, const column<K>& product, const K& density, int left,
                              std::size_t first) -> void {
            if (left == 0) {
                grown.push_back({product, density * K(n), n});
                return;
            }
            for (std::size_t k = first; k < begin; ++k) {
                if (trees[k].order > left) break;
                column<K> next(s);
                for (Eigen::Index i = 0; i < s; ++i) next[i] = product[i] * branches[k][i];
                self(self, next, density * trees[k].density, left - trees[k].order, k);
            }
        };
        column<K> one(s);
        for (Eigen::Index i = 0; i < s; ++i) one[i] = K(1);
        grow(grow, one, K(1), n - 1, 0);
        if (n == 1) grown.push_back(grown.front());  // a second leaf, for the time: its branch is c
        for (auto& tree : grown) {
            column<K> branch(s);
            for (Eigen::Index i = 0; i < s; ++i) {
                branch[i] = K(0);
                for (Eigen::Index j = 0; j < s; ++j) branch[i] = branch[i] + t.A(i, j) * tree.stages[j];
            }
            if (n == 1 && trees.size() == 1) {
                if (branch == t.c) break;  // row sums: time is no different
                branch = t.c;
            }
            branches.push_back(std::move(branch));
            trees.push_back(std::move(tree));
        }
    }
    return trees;
}

}  // namespace detail

/// All weights of a given order for the stages of a method: particular + span of the directions.
template <class K>
struct weight_family {
    column<K> particular;
    std::vector<column<K>> directions;
};

/// The weights b with which c | A has at least the given order: an affine space, or nothing where there are
/// none. Linear algebra over the order conditions of every rooted tree up to `order`; at most s of them are
/// kept. Throws std::invalid_argument for an order outside 1..10 (1205 trees).
template <class K>
std::optional<weight_family<K>> weights_of_order(const stagecraft::tableau<K>& t, int order) {
    require_shape(t);
    if (order < 1 || order > 10) throw std::invalid_argument("order: must lie in 1..10");
    const auto s = t.b.size();
    dense<K> system(0, s + 1);
    for (const auto& condition : detail::weight_conditions(t, order)) {
        dense<K> next(system.rows() + 1, s + 1);
        next.topRows(system.rows()) = system;
        for (Eigen::Index j = 0; j < s; ++j) next(system.rows(), j) = condition.stages[j];
        next(system.rows(), s) = K(1) / condition.density;
        const auto pivots = detail::eliminate<K>(next, s + 1);
        if (!pivots.empty() && pivots.back() == s) return {};  // 0 = 1
        system = next.topRows(static_cast<Eigen::Index>(pivots.size()));
    }
    const auto pivots = detail::eliminate<K>(system, s + 1);
    weight_family<K> family;
    family.particular.resize(s);
    for (Eigen::Index j = 0; j < s; ++j) family.particular[j] = K(0);
    for (std::size_t k = 0; k < pivots.size(); ++k) {
        family.particular[pivots[k]] = system(static_cast<Eigen::Index>(k), s);
    }
    std::size_t next = 0;
    for (Eigen::Index j = 0; j < s; ++j) {
        if (next < pivots.size() && pivots[next] == j) {
            ++next;
            continue;
        }
        column<K> v(s);
        for (Eigen::Index i = 0; i < s; ++i) v[i] = K(i == j ? 1 : 0);
        for (std::size_t k = 0; k < pivots.size(); ++k) {
            v[pivots[k]] = K(0) - system(static_cast<Eigen::Index>(k), j);
        }
        family.directions.push_back(std::move(v));
    }
    return family;
}

/// Embedded weights of the given order that differ from b: the member of `weights_of_order` with zeros in the
/// free entries or, where that is b, b plus a quarter of the first direction (an author who wants another
/// scaling of the error estimate takes another member). Nothing where no weights other than b have the order.
template <class K>
std::optional<column<K>> embedded_weights(const stagecraft::tableau<K>& t, int order) {
    const auto family = weights_of_order(t, order);
    if (!family) return {};
    const auto s = t.b.size();
    const auto equals_b = [&](const column<K>& v) {
        for (Eigen::Index i = 0; i < s; ++i) {
            if (!(v[i] == t.b[i])) return false;
        }
        return true;
    };
    if (!equals_b(family->particular)) return family->particular;
    if (family->directions.empty()) return {};
    column<K> v(s);
    for (Eigen::Index i = 0; i < s; ++i) v[i] = t.b[i] + family->directions.front()[i] / K(4);
    return v;
}

}  // namespace stagecraft::tableaux
