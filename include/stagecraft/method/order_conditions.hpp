// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <stagecraft/method/simplifying_assumptions.hpp>
#include <stagecraft/method/tree_table.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// Largest order at which every rooted tree is looked at: 200 trees, each costs s^2.
inline constexpr int largest_tree_order = 8;

namespace detail {

/// The tolerance for order conditions in floating point: sqrt(eps), and 1e-8 for wide types, whose tableaux
/// may hold decimals of fewer digits. Rounding errors lie far below it, the first failing condition far
/// above.
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

/// The criterion of rounded coefficients: equal but for rounding.
struct equal_but_for_rounding {
    template <class Scalar>
    bool operator()(const Scalar& left, const Scalar& right) const {
        return detail::holds(left, right);
    }
};

/// C(2): every stage is of order two at least.
template <class Scalar, int Stages>
bool has_stage_order_two(const tableau<Scalar, Stages>& m) {
    node_power<Scalar> power(m.stages());
    power.advance(m.c);
    return satisfies_stages(m, power, equal_but_for_rounding{});
}

/// visit(phi, gamma, n) for each rooted tree of at most `most` vertices, by their number n: the stages
/// phi(tau), for which the condition of order n is b^T phi(tau) = 1/gamma(tau) (Hairer-Norsett-Wanner
/// I.II.2), until it returns false. Where c is not the row sums of A, as `equal` decides, the trees of
/// non-autonomous problems take part, whose time leaves bear c. s^2 operations a tree; there are 200 up to
/// order 8, 1205 up to order 10.
template <class Scalar, int Stages, class Equal, class Visit>
void visit_trees(const tableau<Scalar, Stages>& m, int most, Equal equal, Visit&& visit) {
    using column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    if (most < 1) return;
    const int s = m.stages();
    const auto times_a = [&](const column& v) {
        column product(s);
        for (int i = 0; i < s; ++i) {
            product[i] = Scalar(0);
            for (int j = 0; j < s; ++j) product[i] = product[i] + m.A(i, j) * v[j];
        }
        return product;
    };
    column one(s), c(s);
    for (int i = 0; i < s; ++i) one[i] = Scalar(1), c[i] = m.c[i];
    const column row_sums = times_a(one);
    bool time_differs = false;
    for (int i = 0; i < s; ++i) time_differs = time_differs || !equal(row_sums[i], c[i]);
    const tree_table table(most, time_differs);
    const tree_view& trees = table.view();
    std::vector<column> stages, branches;  // phi and A phi, by row of the table
    for (std::uint32_t row = 0; row < trees.rows.size(); ++row) {
        const tree_row& t = trees.rows[row];
        if (trees.is_time_leaf(row)) {
            stages.push_back(one);
            branches.push_back(c);
            continue;
        }
        column phi = one;
        if (t.order > 1)
            for (int i = 0; i < s; ++i) phi[i] = stages[t.left][i] * branches[t.right][i];
        if (!visit(phi, Scalar(t.density), int(t.order))) return;
        if (t.order == most) continue;
        branches.push_back(times_a(phi));
        stages.push_back(std::move(phi));
    }
}

/// The same with the criterion of rounded coefficients.
template <class Scalar, int Stages, class Visit>
void visit_trees(const tableau<Scalar, Stages>& m, int most, Visit&& visit) {
    visit_trees(m, most, equal_but_for_rounding{}, visit);
}

/// Largest p <= most for which the weights b satisfy the conditions of all rooted trees with at most p
/// vertices (visit_trees); `equal` decides.
template <class Scalar, int Stages, class Weights, class Equal = equal_but_for_rounding>
int order_by_trees(const tableau<Scalar, Stages>& m, const Weights& b, int most, Equal equal = {}) {
    int order = most;
    visit_trees(m, most, equal, [&](const auto& stages, const Scalar& density, int n) {
        Scalar sum = Scalar(0);
        for (int i = 0; i < m.stages(); ++i) sum = sum + b[i] * stages[i];
        if (equal(Scalar(sum * density), Scalar(1))) return true;
        order = n - 1;
        return false;
    });
    return order;
}

/// Largest p with B(p), sum_i b_i c_i^{k-1} = 1/k for k <= p, at most `most`, but for rounding.
template <class Scalar, int Stages>
int quadrature_conditions(const tableau<Scalar, Stages>& m, int most) {
    node_power<Scalar> power(m.stages());
    while (power.k() <= most && satisfies_quadrature(m, power, equal_but_for_rounding{})) power.advance(m.c);
    return power.k() - 1;
}

/// Largest q with C(q), sum_j a_ij c_j^{k-1} = c_i^k / k for all i and k <= q, at most `most`, but for
/// rounding.
template <class Scalar, int Stages>
int stage_conditions(const tableau<Scalar, Stages>& m, int most) {
    node_power<Scalar> power(m.stages());
    while (power.k() <= most && satisfies_stages(m, power, equal_but_for_rounding{})) power.advance(m.c);
    return power.k() - 1;
}

/// The order of a method: by all rooted trees up to order `most`, and beyond it what Butcher's theorem gives,
/// min(B, C + D + 1, 2 C + 2) (Hairer-Wanner II.IV.5.1), a lower bound there. `equal` decides.
template <class Scalar, int Stages, class Equal>
int classical_order(const tableau<Scalar, Stages>& m, int most, Equal equal) {
    const auto n = simplifying_orders_of(m, equal);
    if (n.C > 0 && n.order() == n.B) return n.B;
    const int reach = n.B < most ? n.B : most;  // B(p) is necessary
    const int by_trees = order_by_trees(m, m.b, reach, equal);
    return by_trees < reach || n.order() < by_trees ? by_trees : n.order();
}

/// The order the stepper counts on: facts.order where a certificate gave it, else the order but for rounding,
/// every tree looked at up to largest_tree_order.
template <class Scalar, int Stages>
int classical_order(const tableau<Scalar, Stages>& m) {
    return m.facts.order > 0 ? m.facts.order
                             : classical_order(m, largest_tree_order, equal_but_for_rounding{});
}

}  // namespace stagecraft
