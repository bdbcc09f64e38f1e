// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// Largest order at which every rooted tree is looked at: 200 trees, each costs s^2.
inline constexpr int largest_tree_order = 8;

namespace detail {

/// Rounding and the first failing condition lie far on either side of it: sqrt(eps), and 1e-8 for wide types,
/// whose tableaux may hold decimals of fewer digits.
template <class Scalar>
Scalar condition_tolerance() {
    using std::sqrt;
    const Scalar root = sqrt(std::numeric_limits<Scalar>::epsilon()), least = Scalar(1) / 100000000;
    return root > least ? root : least;
}

/// Equal but for rounding; numbers below one are compared relatively.
template <class Scalar>
bool holds(const Scalar& left, const Scalar& right) {
    using std::abs;
    const Scalar difference = abs(left - right), size = abs(right);
    return difference <= condition_tolerance<Scalar>() * (size < Scalar(1) ? size : Scalar(1)) ||
           difference <= Scalar(64) * std::numeric_limits<Scalar>::epsilon();
}

}  // namespace detail

/// visit(phi, gamma, n) for each rooted tree of at most `most` vertices, by their number n: the stages
/// phi(tau), for which the condition of order n is b^T phi(tau) = 1/gamma(tau) (Hairer-Norsett-Wanner
/// I.II.2), until it returns false. Where c is not the row sums of A the trees of non-autonomous problems
/// take part, whose time leaves bear c. most <= largest_tree_order.
template <class Scalar, int Stages, class Visit>
void visit_trees(const tableau<Scalar, Stages>& m, int most, Visit&& visit) {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    struct tree {
        column branch;  // A times the stage vector, or c for a time leaf
        Scalar density;
        int order;
    };
    struct grown_tree {
        column stages;
        Scalar density;
    };
    const int s = m.stages();
    std::vector<tree> trees;
    for (int n = 1; n <= most; ++n) {
        std::vector<grown_tree> grown;
        const auto grow = [&](auto& self, const column& product, const Scalar& density, int left,
                              std::size_t first) -> void {
            if (left == 0) {
                grown.push_back({product, density * Scalar(n)});
                return;
            }
            for (std::size_t k = first; k < trees.size() && trees[k].order <= left; ++k)
                self(self, column(product.cwiseProduct(trees[k].branch)), Scalar(density * trees[k].density),
                     left - trees[k].order, k);
        };
        grow(grow, column(column::Ones(s)), Scalar(1), n - 1, 0);
        for (const auto& g : grown)
            if (!visit(g.stages, g.density, n)) return;
        if (n == most) break;
        for (auto& g : grown) {
            column branch = column::Zero(s);
            for (int i = 0; i < s; ++i)
                for (int j = 0; j < s; ++j) branch[i] += m.A(i, j) * g.stages[j];
            bool time_differs = false;
            if (n == 1)
                for (int i = 0; i < s; ++i) time_differs = time_differs || !detail::holds(branch[i], m.c[i]);
            trees.push_back({std::move(branch), g.density, n});
            if (time_differs) trees.push_back({column(m.c), g.density, n});
        }
    }
}

/// Largest p <= most for which the weights b satisfy the conditions of all rooted trees with at most p
/// vertices (visit_trees), relatively to condition_tolerance. most <= largest_tree_order.
template <class Scalar, int Stages, class Weights>
int order_by_trees(const tableau<Scalar, Stages>& m, const Weights& b, int most) {
    int order = most;
    visit_trees(m, most, [&](const auto& stages, const Scalar& density, int n) {
        Scalar sum = Scalar(0);
        for (int i = 0; i < m.stages(); ++i) sum += b[i] * stages[i];
        if (detail::holds(Scalar(sum * density), Scalar(1))) return true;
        order = n - 1;
        return false;
    });
    return order;
}

/// Largest p with B(p), sum_i b_i c_i^{k-1} = 1/k for k <= p, at most `most`.
template <class Scalar, int Stages>
int quadrature_conditions(const tableau<Scalar, Stages>& m, int most) {
    const int s = m.stages();
    std::vector<Scalar> power(static_cast<std::size_t>(s), Scalar(1));
    for (int k = 1; k <= most; ++k) {
        Scalar sum = Scalar(0);
        for (int i = 0; i < s; ++i) {
            sum += m.b[i] * power[i];
            power[i] *= m.c[i];
        }
        if (!detail::holds(Scalar(sum * Scalar(k)), Scalar(1))) return k - 1;
    }
    return most;
}

/// Largest q with C(q), sum_j a_ij c_j^{k-1} = c_i^k / k for all i and k <= q, at most `most`.
template <class Scalar, int Stages>
int stage_conditions(const tableau<Scalar, Stages>& m, int most) {
    const int s = m.stages();
    std::vector<Scalar> power(static_cast<std::size_t>(s), Scalar(1));
    for (int k = 1; k <= most; ++k) {
        for (int i = 0; i < s; ++i) {
            Scalar sum = Scalar(0);
            for (int j = 0; j < s; ++j) sum += m.A(i, j) * power[j];
            if (!detail::holds(Scalar(sum * Scalar(k)), Scalar(power[i] * m.c[i]))) return k - 1;
        }
        for (int i = 0; i < s; ++i) power[i] *= m.c[i];
    }
    return most;
}

/// Largest r with D(r), sum_i b_i c_i^{k-1} a_ij = b_j (1 - c_j^k) / k for all j and k <= r, at most `most`.
template <class Scalar, int Stages>
int adjoint_conditions(const tableau<Scalar, Stages>& m, int most) {
    const int s = m.stages();
    std::vector<Scalar> power(static_cast<std::size_t>(s), Scalar(1));
    for (int k = 1; k <= most; ++k) {
        for (int j = 0; j < s; ++j) {
            Scalar sum = Scalar(0);
            for (int i = 0; i < s; ++i) sum += m.b[i] * power[i] * m.A(i, j);
            if (!detail::holds(Scalar(sum * Scalar(k)), Scalar(m.b[j] * (Scalar(1) - power[j] * m.c[j]))))
                return k - 1;
        }
        for (int i = 0; i < s; ++i) power[i] *= m.c[i];
    }
    return most;
}

/// The order the stepper counts on: facts.order where a certificate gave it, else the order up to
/// largest_tree_order by all rooted trees, and beyond it what Butcher's theorem gives, min(B, C + D + 1,
/// 2 C + 2) (Hairer-Wanner II.IV.5.1). Never larger than the order of the coefficients to that tolerance.
template <class Scalar, int Stages>
int classical_order(const tableau<Scalar, Stages>& m) {
    if (m.facts.order > 0) return m.facts.order;
    const int by_trees = order_by_trees(m, m.b, largest_tree_order);
    if (by_trees < largest_tree_order) return by_trees;
    const int s = m.stages();
    const int B = quadrature_conditions(m, 2 * s), C = stage_conditions(m, s), D = adjoint_conditions(m, s);
    int bound = C + D + 1 < 2 * C + 2 ? C + D + 1 : 2 * C + 2;
    if (B < bound) bound = B;
    return bound > by_trees ? bound : by_trees;
}

}  // namespace stagecraft
