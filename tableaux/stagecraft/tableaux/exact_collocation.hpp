// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stagecraft/tableaux/simplifying.hpp"

namespace stagecraft::tableaux {

/// A method together with what its construction knows: an order (a lower bound unless `exact_order`), and the
/// reason for it.
template <class K>
struct constructed {
    stagecraft::tableau<K> tableau;
    int order = 0;
    bool exact_order = false;
    std::string reason;
};

namespace detail {

template <class K>
void require_distinct(const std::vector<K>& nodes) {
    if (nodes.empty()) throw std::invalid_argument("nodes: at least one is needed");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (nodes[i] == nodes[j]) {
                throw std::invalid_argument("nodes: " + std::to_string(j + 1) + " and " +
                                            std::to_string(i + 1) + " are equal");
            }
        }
    }
}

template <class K>
stagecraft::tableau<K> empty_tableau(const std::vector<K>& nodes) {
    stagecraft::tableau<K> t;
    const auto s = static_cast<Eigen::Index>(nodes.size());
    t.A.resize(s, s);
    t.b.resize(s);
    t.c.resize(s);
    for (Eigen::Index i = 0; i < s; ++i) t.c[i] = nodes[static_cast<std::size_t>(i)];
    return t;
}

}  // namespace detail

/// prod (x - c_i).
template <class K>
polynomial<K> nodal_product(const std::vector<K>& nodes) {
    polynomial<K> w(K(1));
    for (const K& c : nodes) w *= polynomial<K>{K(0) - c, K(1)};
    return w;
}

/// The Lagrange polynomials of distinct nodes. Throws std::invalid_argument where two are equal. O(s^2).
template <class K>
std::vector<polynomial<K>> lagrange_basis(const std::vector<K>& nodes) {
    detail::require_distinct(nodes);
    const auto w = nodal_product(nodes);
    std::vector<polynomial<K>> basis;
    for (const K& c : nodes) {
        const auto others = w / polynomial<K>{K(0) - c, K(1)};
        basis.push_back(others * polynomial<K>(K(1) / others(c)));
    }
    return basis;
}

/// How many of 1, x, x^2, ... the nodal polynomial is orthogonal to on [0, 1]: the interpolatory quadrature
/// has order s + m (Jacobi; lecture, Satz 2.12).
template <class K>
int orthogonality(const std::vector<K>& nodes) {
    const auto w = nodal_product(nodes);
    for (int m = 0;; ++m) {  // it ends: w is not orthogonal to itself
        if (!(integral(w * polynomial<K>::monomial(m))(K(1)) == K(0))) return m;
    }
}

/// The collocation method of distinct nodes: a_ij = int_0^{c_i} L_j, b_j = int_0^1 L_j
/// (Hairer-Norsett-Wanner I, Theorem II.7.7). C(s) holds and the order is exactly that of the quadrature.
/// Throws std::invalid_argument for equal nodes.
template <class K>
constructed<K> collocation(const std::vector<K>& nodes) {
    const auto basis = lagrange_basis(nodes);
    constructed<K> out{detail::empty_tableau(nodes), 0, true, {}};
    auto& t = out.tableau;
    for (std::size_t j = 0; j < basis.size(); ++j) {
        const auto primitive = integral(basis[j]);
        const auto col = static_cast<Eigen::Index>(j);
        t.b[col] = primitive(K(1));
        for (Eigen::Index i = 0; i < t.c.size(); ++i) t.A(i, col) = primitive(t.c[i]);
    }
    const int m = orthogonality(nodes);
    out.order = static_cast<int>(nodes.size()) + m;
    out.reason = "collocation with " + std::to_string(nodes.size()) +
                 " nodes, nodal polynomial orthogonal to " +
                 (m == 0   ? "no power of x"
                  : m == 1 ? "1"
                           : "1, ..., x^" + std::to_string(m - 1)) +
                 ": C(s) and B(s + " + std::to_string(m) + ")";
    return out;
}

/// Discontinuous collocation on 0, the inner nodes, and 1, with weights b_first and b_last at the ends:
/// a_i1 = b_first, a_is = 0, the rest by C(s-2) and B(s-2) (Hairer-Lubich-Wanner, Definition II.1.7 and
/// Theorem II.1.8). Lobatto IIIB is the case of Lobatto nodes and weights. The order is that of the
/// quadrature. Throws std::invalid_argument for equal inner nodes.
template <class K>
constructed<K> discontinuous_collocation(const std::vector<K>& inner, const K& b_first, const K& b_last) {
    std::vector<K> nodes{K(0)};
    nodes.insert(nodes.end(), inner.begin(), inner.end());
    nodes.push_back(K(1));
    constructed<K> out{detail::empty_tableau(nodes), 0, false, {}};
    auto& t = out.tableau;
    const auto s = t.c.size();
    t.b[0] = b_first;
    t.b[s - 1] = b_last;
    for (Eigen::Index i = 0; i < s; ++i) {
        t.A(i, 0) = b_first;
        t.A(i, s - 1) = K(0);
    }
    const auto basis = inner.empty() ? std::vector<polynomial<K>>{} : lagrange_basis(inner);
    for (std::size_t j = 0; j < basis.size(); ++j) {
        // int_0^x p = b_first p(0) + sum_j a_j p(c_j) for p of degree <= s - 3
        const auto primitive = integral(basis[j]);
        const K at_zero = basis[j](K(0));
        const K at_one = basis[j](K(1));
        const auto col = static_cast<Eigen::Index>(j) + 1;
        t.b[col] = primitive(K(1)) - b_first * at_zero - b_last * at_one;
        for (Eigen::Index i = 0; i < s; ++i) t.A(i, col) = primitive(t.c[i]) - b_first * at_zero;
    }
    out.order = simplifying_orders_of(t).B;
    out.reason =
        "discontinuous collocation: the order of its quadrature, B(" + std::to_string(out.order) + ")";
    return out;
}

/// Perturbed collocation (Norsett and Wanner 1981): u' = f(., u + sum_k N_k u^(k)(0)) at the nodes, with
/// perturbations N_1, ..., N_s (polynomials in x on [0, 1], scaled so that h = 1). Every method with distinct
/// nodes and interpolatory weights is one. The order stated is Butcher's bound from B, C, D.
/// Throws std::invalid_argument for equal nodes or more than s perturbations.
template <class K>
constructed<K> perturbed_collocation(const std::vector<K>& nodes,
                                     const std::vector<polynomial<K>>& perturbations) {
    if (perturbations.size() > nodes.size()) {
        throw std::invalid_argument("perturbations: more than there are nodes");
    }
    auto out = collocation(nodes);
    auto& t = out.tableau;
    const auto basis = lagrange_basis(nodes);
    for (std::size_t j = 0; j < basis.size(); ++j) {
        K factorial(1);  // (k-1)!: L_j^(k-1)(0) = (k-1)! times its coefficient
        for (std::size_t k = 0; k < perturbations.size(); ++k) {
            if (k > 0) factorial = factorial * K(static_cast<int>(k));
            const K derivative_at_zero = factorial * basis[j][static_cast<int>(k)];
            for (Eigen::Index i = 0; i < t.c.size(); ++i) {
                auto& a = t.A(i, static_cast<Eigen::Index>(j));
                a = a + perturbations[k](t.c[i]) * derivative_at_zero;
            }
        }
    }
    const auto n = simplifying_orders_of(t);
    out.order = n.order();
    out.exact_order = out.order == n.B;
    out.reason = "perturbed collocation: B(" + std::to_string(n.B) + "), C(" + std::to_string(n.C) + "), D(" +
                 std::to_string(n.D) + ")";
    return out;
}

}  // namespace stagecraft::tableaux
