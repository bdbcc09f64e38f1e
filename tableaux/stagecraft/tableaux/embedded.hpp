// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stagecraft/method/order_conditions.hpp"
#include "stagecraft/tableaux/simplifying.hpp"

namespace stagecraft::tableaux {

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
    bool solvable = true;
    visit_trees(t, order, std::equal_to<>{}, [&](const auto& stages, const K& density, int) {
        dense<K> next(system.rows() + 1, s + 1);
        next.topRows(system.rows()) = system;
        for (Eigen::Index j = 0; j < s; ++j) next(system.rows(), j) = stages[j];
        next(system.rows(), s) = K(1) / density;
        const auto pivots = detail::eliminate<K>(next, s + 1);
        solvable = pivots.empty() || pivots.back() != s;  // else 0 = 1
        system = next.topRows(static_cast<Eigen::Index>(pivots.size()));
        return solvable;
    });
    if (!solvable) return {};
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
/// free entries, or b plus a quarter of the first direction if that member is b. (For another scaling of the
/// error estimate take another member.) Nothing if b alone has the order.
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
