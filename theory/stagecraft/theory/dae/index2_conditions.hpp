// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

#include "stagecraft/theory/stability/stability_function.hpp"

namespace stagecraft::theory {

/// How far the order conditions for y' = f(y, z), 0 = g(y), g_y f_z regular, hold (index 2). Up to the order
/// at which the search ended all three are exact.
struct index2_local_orders {
    int y = 0;          ///< largest n with every y-condition of order <= n: local error of y is O(h^{n+1})
    int projected = 0;  ///< the same without the trees [u]_y, which P = I - f_z (g_y f_z)^-1 g_y removes
    int z = 0;          ///< largest n with every z-condition of order <= n: local error of z is O(h^{n+1})
    int searched = 0;   ///< conditions up to this order were looked at
};

namespace detail {

/// The stage vectors of the trees of index 2 (HLR89, section 5; Hairer-Wanner II.VII.5), scaled by the
/// density so that a method of infinite order would have c^n for every tree of order n: a y-tree of order n
/// is n times a product of branches of total order n - 1, its branch A times that; a z-tree of order n is
/// A^-1 times a product of y-branches of total order n + 1, over n + 1, or a product of branches of total
/// order n itself. Trees with equal vectors are kept once: with C(q) the first q orders collapse to one
/// vector each; `equal` decides it.
template <class K, class Equal>
class index2_trees {
  public:
    index2_trees(const tableau<K>& t, const tableaux::dense<K>& inverse, const Equal& equal)
        : t_(t), inverse_(inverse), equal_(equal) {}

    /// Grows the trees of the next order; calls y(vector, removed_by_projection) and z(vector) with the
    /// scaled stage vectors of all new ones, where b^T vector = 1 and b^T A^-1 vector = 1 are the conditions.
    template <class Y, class Z>
    void grow(Y&& y, Z&& z) {
        const int n = static_cast<int>(y_.size()) + 1;
        std::vector<tableaux::column<K>> y_new;
        const auto one = ones<K>(t_.b.size());
        products(one, n - 1, true, 0, 0, 0, [&](const tableaux::column<K>& product, int count, bool z_last) {
            auto vector = scaled(product, K(n));
            y(vector, count == 1 && z_last);
            keep(y_new, times(t_.A, vector));
        });
        y_.push_back(std::move(y_new));
        std::vector<tableaux::column<K>> z_new;
        products(one, n + 1, false, 0, 0, 0, [&](const tableaux::column<K>& product, int count, bool) {
            if (count > 1) keep(z_new, scaled(times(inverse_, product), K(1) / K(n + 1)));
        });
        products(one, n, true, 0, 0, 0,
                 [&](const tableaux::column<K>& product, int, bool) { keep(z_new, product); });
        for (const auto& vector : z_new) z(vector);
        z_.push_back(std::move(z_new));
    }

  private:
    /// All products of branches of total order `left`: y-branches first, then (with_z) z-branches, each
    /// list without going back. Only orders grown so far exist, so no tree contains itself.
    template <class Each>
    void products(const tableaux::column<K>& product, int left, bool with_z, std::size_t position, int count,
                  int kind, Each&& each) const {
        if (left == 0) {
            each(product, count, kind == 1);
            return;
        }
        for (int k = kind; k <= (with_z ? 1 : 0); ++k) {
            std::size_t index = 0;
            const auto& lists = k == 0 ? y_ : z_;
            for (int order = 1; order <= static_cast<int>(lists.size()) && order <= left; ++order) {
                for (const auto& branch : lists[static_cast<std::size_t>(order) - 1]) {
                    if (k == kind && index < position) {
                        ++index;
                        continue;
                    }
                    tableaux::column<K> next(product.size());
                    for (Eigen::Index i = 0; i < next.size(); ++i) next[i] = product[i] * branch[i];
                    products(next, left - order, with_z, index, count + 1, k, each);
                    ++index;
                }
            }
        }
    }
    static tableaux::column<K> scaled(tableaux::column<K> v, const K& factor) {
        for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = v[i] * factor;
        return v;
    }
    static tableaux::column<K> times(const tableaux::dense<K>& m, const tableaux::column<K>& v) {
        tableaux::column<K> out(v.size());
        for (Eigen::Index i = 0; i < v.size(); ++i) {
            out[i] = K(0);
            for (Eigen::Index j = 0; j < v.size(); ++j) out[i] = out[i] + m(i, j) * v[j];
        }
        return out;
    }
    void keep(std::vector<tableaux::column<K>>& list, const tableaux::column<K>& v) const {
        for (const auto& old : list) {
            bool equal = true;
            for (Eigen::Index i = 0; i < v.size() && equal; ++i) equal = equal_(old[i], v[i]);
            if (equal) return;
        }
        list.push_back(v);
    }

    const tableau<K>& t_;
    const tableaux::dense<K>& inverse_;
    const Equal& equal_;
    std::vector<std::vector<tableaux::column<K>>> y_;
    std::vector<std::vector<tableaux::column<K>>> z_;
};

}  // namespace detail

/// The local orders by the order conditions, looked for up to `max_order`, with `inverse` for A^-1; `equal` decides an equation.
/// The search ends early once y, P y and z have all failed. Cost grows quickly with max_order for methods of low
/// stage order. Throws std::invalid_argument for max_order < 1.
template <class K, class Equal>
index2_local_orders index2_local_orders_of(const tableau<K>& t, const tableaux::dense<K>& inverse,
                                           int max_order, const Equal& equal) {
    if (max_order < 1) throw std::invalid_argument("max_order: must be positive");
    const auto s = t.b.size();
    tableaux::column<K> row(s);  // b^T A^-1
    for (Eigen::Index j = 0; j < s; ++j) {
        row[j] = K(0);
        for (Eigen::Index i = 0; i < s; ++i) row[j] = row[j] + t.b[i] * inverse(i, j);
    }
    const auto holds = [&](const tableaux::column<K>& weights, const tableaux::column<K>& v) {
        K sum(0);
        for (Eigen::Index i = 0; i < s; ++i) sum = sum + weights[i] * v[i];
        return equal(sum, K(1));
    };
    detail::index2_trees<K, Equal> trees(t, inverse, equal);
    index2_local_orders out;
    bool y = true, projected = true, z = true;
    for (int n = 1; n <= max_order && (y || projected || z); ++n) {
        trees.grow(
            [&](const tableaux::column<K>& v, bool removed) {
                if (holds(t.b, v)) return;
                y = false;
                if (!removed) projected = false;
            },
            [&](const tableaux::column<K>& v) { z = z && holds(row, v); });
        out.searched = n;
        if (y) out.y = n;
        if (projected) out.projected = n;
        if (z) out.z = n;
    }
    return out;
}

/// The same over an exact field; nothing where A is singular.
template <class K>
std::optional<index2_local_orders> index2_local_orders_of(const tableau<K>& t, int max_order) {
    require_shape(t);
    const auto inverse = tableaux::inverse<K>(t.A);
    if (!inverse) return {};
    return index2_local_orders_of(t, *inverse, max_order, std::equal_to<>{});
}

/// What stands for A^-1 where the first stage is the left end of the step (row 1 of A and c_1 are 0): the inverse of the rest of
/// A, bordered by zeros, as Y_1 = y_n and Z_1 = z_n are given; nothing where that rest is singular.
template <class K>
std::optional<tableaux::dense<K>> left_stage_inverse(const tableau<K>& t) {
    const auto s = t.b.size();
    bool left = s > 1 && t.c[0] == K(0);
    for (Eigen::Index j = 0; j < s; ++j) left = left && t.A(0, j) == K(0);
    if (!left) return {};
    const auto rest = tableaux::inverse<K>(t.A.bottomRightCorner(s - 1, s - 1));
    if (!rest) return {};
    tableaux::dense<K> all(s, s);
    for (Eigen::Index i = 0; i < s; ++i)
        for (Eigen::Index j = 0; j < s; ++j) all(i, j) = i == 0 || j == 0 ? K(0) : (*rest)(i - 1, j - 1);
    return all;
}

}  // namespace stagecraft::theory
