// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "stagecraft/tableaux/exact_collocation.hpp"
#include "stagecraft/tableaux/legendre.hpp"

namespace stagecraft::tableaux {

/// W_ij = P_{j-1}(c_i), the shifted Legendre polynomials at the nodes (Hairer-Wanner II, section IV.5). They
/// are not normalised, P_k(1) = 1, which keeps everything inside the field: Hairer and Wanner's matrix is
/// W diag(sqrt(2j - 1)).
template <class K>
dense<K> legendre_matrix(const std::vector<K>& nodes) {
    const auto s = static_cast<Eigen::Index>(nodes.size());
    dense<K> w(s, s);
    for (Eigen::Index j = 0; j < s; ++j) {
        const auto p = shifted_legendre<K>(static_cast<int>(j));
        for (Eigen::Index i = 0; i < s; ++i) w(i, j) = p(nodes[static_cast<std::size_t>(i)]);
    }
    return w;
}

/// Integration from 0 in the basis P_0, ..., P_{s-1}, the degree s cut off: the X of the Gauss methods
/// (Hairer-Wanner II, Theorem IV.5.6, there in the normalised basis with xi_k = 1/(2 sqrt(4 k^2 - 1))).
template <class K>
dense<K> legendre_integration(int s) {
    if (s < 1) throw std::invalid_argument("s: must be positive");
    dense<K> x(s, s);
    for (int i = 0; i < s; ++i) {
        for (int j = 0; j < s; ++j) x(i, j) = K(0);
    }
    x(0, 0) = K(1) / K(2);
    for (int k = 0; k + 1 < s; ++k) {
        x(k + 1, k) = K(1) / K(2 * (2 * k + 1));
        x(k, k + 1) = K(-1) / K(2 * (2 * k + 3));
    }
    return x;
}

/// X = W^-1 A W, the method in Legendre coordinates. Throws std::invalid_argument for equal nodes.
template <class K>
dense<K> w_transformed(const stagecraft::tableau<K>& t) {
    require_shape(t);
    const std::vector<K> nodes(t.c.data(), t.c.data() + t.c.size());
    detail::require_distinct(nodes);
    const auto w = legendre_matrix(nodes);
    const auto s = t.c.size();
    dense<K> product(s, s);
    for (Eigen::Index i = 0; i < s; ++i) {
        for (Eigen::Index j = 0; j < s; ++j) {
            product(i, j) = K(0);
            for (Eigen::Index k = 0; k < s; ++k) product(i, j) = product(i, j) + t.A(i, k) * w(k, j);
        }
    }
    return *solve<K>(w, product);
}

/// The method A = W X W^-1 with interpolatory weights (W-transformation; Hairer-Wanner II, section IV.5): the
/// first q columns of X equal to those of integration give C(q), the first r rows D(r) where the quadrature
/// has order at least s + r. Throws std::invalid_argument for equal nodes or an X that does not fit.
template <class K>
constructed<K> from_W(const dense<K>& X, const std::vector<K>& nodes) {
    auto out = collocation(nodes);
    auto& t = out.tableau;
    const auto s = t.c.size();
    if (X.rows() != s || X.cols() != s) throw std::invalid_argument("X: does not fit the nodes");
    const auto w = legendre_matrix(nodes);
    const auto back = *inverse<K>(w);
    dense<K> product(s, s);
    for (Eigen::Index i = 0; i < s; ++i) {
        for (Eigen::Index j = 0; j < s; ++j) {
            product(i, j) = K(0);
            for (Eigen::Index k = 0; k < s; ++k) product(i, j) = product(i, j) + w(i, k) * X(k, j);
        }
    }
    for (Eigen::Index i = 0; i < s; ++i) {
        for (Eigen::Index j = 0; j < s; ++j) {
            t.A(i, j) = K(0);
            for (Eigen::Index k = 0; k < s; ++k) t.A(i, j) = t.A(i, j) + product(i, k) * back(k, j);
        }
    }
    const auto n = simplifying_orders_of(t);
    out.order = n.order();
    out.exact_order = out.order == n.B;
    out.reason = "W-transformation: B(" + std::to_string(n.B) + "), C(" + std::to_string(n.C) + "), D(" +
                 std::to_string(n.D) + ")";
    return out;
}

}  // namespace stagecraft::tableaux
