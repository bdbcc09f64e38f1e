// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stagecraft/method/order_conditions.hpp"
#include "stagecraft/theory/dae/index2_conditions.hpp"
#include "stagecraft/theory/stability/algebraic_stability.hpp"

namespace stagecraft::theory {

/// A hypothesis of a theorem and the verdict on it for the method at hand.
struct hypothesis {
    std::string name;
    theory::verdict verdict;
};

/// What one theorem says of the global error of a method: y_n - y(t_n) = O(h^y) and so on for the algebraic
/// components, for constant step sizes and consistent initial values. Where a hypothesis fails the orders are
/// empty; z is the Lagrange multiplier lambda for index 1 and 2, for index 3 the velocities, and u then the
/// multiplier. Orders are lower bounds: a theorem's promise, not a measurement.
struct order_prediction {
    std::string theorem;
    std::vector<hypothesis> hypotheses;
    std::optional<int> y;
    std::optional<int> z;
    std::optional<int> u;
    std::string note;

    bool applies() const { return y.has_value(); }
};

/// One term O(eps^epsilon h^h) of an error in a singular perturbation problem.
struct epsilon_term {
    int epsilon = 0;
    int h = 0;
    friend bool operator==(const epsilon_term&, const epsilon_term&) = default;
};

/// Hairer-Wanner II, Corollary VI.3.10 (thesis, Theorem 7) for a method: the errors of y and lambda are sums
/// of these terms.
struct epsilon_prediction {
    std::string theorem;
    std::vector<hypothesis> hypotheses;
    std::vector<epsilon_term> y;
    std::vector<epsilon_term> lambda;

    bool applies() const { return !y.empty(); }
};

/// What the theorems need to know of a method, computed once.
template <class K>
struct dae_traits {
    int stages = 0;
    tableaux::simplifying_orders simplifying;
    int order = 0;             ///< classical order
    int stage_order = 0;       ///< largest q with B(q) and C(q)
    bool regular = false;      ///< A is regular
    bool stiff = false;        ///< stiffly accurate
    bool collocation = false;  ///< distinct nodes, B(s), C(s)
    int zero_node = -1;        ///< the first stage with c_i = 0
    bool ends_at_one = false;  ///< c_s = 1
    std::string last_node;     ///< c_s as text
    std::optional<K> r_infinity;
};

/// The order for y' = f(x, y), decided exactly: by the rooted trees up to order 12, beyond it Butcher's lower
/// bound; where c is not A 1, by the trees with leaves for the time, up to order 8.
template <class K>
int classical_order(const tableau<K>& t) {
    const bool row_sums = tableaux::simplifying_orders_of(t).C > 0;
    return stagecraft::classical_order(t, row_sums ? 12 : 8, std::equal_to<>{});
}

template <class K>
dae_traits<K> dae_traits_of(const tableau<K>& t) {
    require_shape(t);
    dae_traits<K> m;
    m.stages = t.stages();
    m.simplifying = tableaux::simplifying_orders_of(t);
    m.order = classical_order(t);
    m.stage_order = std::min(m.simplifying.B, m.simplifying.C);
    m.regular = regular_matrix(t).is_proved();
    m.stiff = stiffly_accurate(t).is_proved();
    m.r_infinity = stability_function_of(t).at_infinity();
    bool distinct = true;
    for (Eigen::Index i = 0; i < t.c.size(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) distinct = distinct && !(t.c[i] == t.c[j]);
    }
    m.collocation = distinct && m.stage_order >= m.stages;
    for (Eigen::Index i = t.c.size(); i-- > 0;)
        if (t.c[i] == K(0)) m.zero_node = static_cast<int>(i);
    m.ends_at_one = t.c[t.c.size() - 1] == K(1);
    m.last_node = t.c[t.c.size() - 1].str();
    return m;
}

namespace detail {

verdict decided(bool holds, std::string text);

template <class K>
hypothesis regular(const dae_traits<K>& m) {
    return {"A is regular", decided(m.regular, m.regular ? "det A != 0" : "det A = 0")};
}
template <class K>
std::string r_text(const dae_traits<K>& m) {
    return m.r_infinity ? "R(inf) = " + m.r_infinity->str() : "R(inf) is infinite";
}
/// -1, 0, 1 as |R(inf)| is less than, equal to, greater than 1.
template <class K>
int modulus(const dae_traits<K>& m) {
    return m.r_infinity ? tableaux::sign_of(*m.r_infinity * *m.r_infinity - K(1)) : 1;
}
template <class K>
hypothesis damped(const dae_traits<K>& m) {
    return {"|R(inf)| < 1", decided(modulus(m) < 0, r_text(m))};
}
template <class K>
hypothesis stiff(const dae_traits<K>& m) {
    return {"stiffly accurate", decided(m.stiff, m.stiff ? "a_si = b_i" : "the last row of A is not b")};
}
template <class K>
hypothesis bounded(const dae_traits<K>& m) {
    return {"|R(inf)| <= 1", decided(modulus(m) <= 0, r_text(m))};
}
template <class K>
hypothesis of_order_one(const dae_traits<K>& m) {
    return {"p >= 1", decided(m.order >= 1, "p = " + std::to_string(m.order))};
}
template <class K>
hypothesis is_collocation(const dae_traits<K>& m) {
    return {"collocation method", decided(m.collocation, "B(" + std::to_string(m.simplifying.B) + "), C(" +
                                                             std::to_string(m.simplifying.C) +
                                                             "), s = " + std::to_string(m.stages))};
}
template <class K>
hypothesis no_node_at_zero(const dae_traits<K>& m) {
    const bool none = m.zero_node < 0;
    return {"c_i != 0",
            decided(none, none ? "no node vanishes" : "c_" + std::to_string(m.zero_node + 1) + " = 0")};
}
template <class K>
hypothesis last_node_is_one(const dae_traits<K>& m) {
    return {"c_s = 1", decided(m.ends_at_one, "c_s = " + m.last_node)};
}

bool all_proved(const std::vector<hypothesis>& list);

/// The applicable prediction with the largest (y, z); where none applies, one that
/// says so and lists every hypothesis that fails.
order_prediction best_of(const std::vector<order_prediction>& all);

}  // namespace detail

namespace detail {

/// A theorem as a row of a table: where it stands, what it asks, and what it gives where all of that is
/// proved.
struct theorem {
    std::string citation;
    std::vector<hypothesis> hypotheses;
    std::function<void(order_prediction&)> conclusion;

    order_prediction applied() const;
    /// For the only theorem on its problem.
    order_prediction applied_or_none() const;
};

/// The order conditions of index 2 with the convergence theorems, looked at up to `most`.
template <class K>
theorem index2_by_conditions(const tableau<K>& t, const dae_traits<K>& m, int most) {
    theorem row{"order conditions of index 2 (Hairer-Lubich-Roche 1989, section 5, Theorems 4.4 and 4.6)",
                {regular(m), damped(m)},
                [](order_prediction&) {}};
    const auto n = index2_local_orders_of(t, most);
    if (!n) return row;
    const int r = std::min(n->y + 1, n->projected);
    row.hypotheses.push_back(
        {"local error of y at least O(h^2)",
         decided(r >= 1, "conditions of y hold to order " + std::to_string(n->y) + ", of P y to " +
                             std::to_string(n->projected) + ", of z to " + std::to_string(n->z))});
    row.conclusion = [n = *n, r, most, stiff = m.stiff](order_prediction& p) {
        p.y = r;
        // Theorem 4.6 wants g(y_n) = O(h^{k+1}): exact for stiffly accurate methods
        p.z = std::min({n.z + 1, r, stiff ? r : n.y});
        if (n.searched == most && n.y == most)
            p.note = "conditions searched to order " + std::to_string(most) + " only";
    };
    return row;
}

/// What is published for index 2, but for the order conditions.
template <class K>
std::vector<theorem> index2_table(const dae_traits<K>& m) {
    const auto& n = m.simplifying;
    const std::string B = "B(" + std::to_string(n.B) + ")", C = "C(" + std::to_string(n.C) + ")",
                      D = "D(" + std::to_string(n.D) + ")";
    const int q = std::min(n.C, n.B - 1);
    const hypothesis stages{"B(p), C(q), p > q >= 1", decided(q >= 1, B + ", " + C)};
    const bool alternating = m.r_infinity && *m.r_infinity < K(0);
    return {
        {"Hairer-Lubich-Roche 1989, Theorems 4.3, 4.4 and 4.6",  // thesis, Theorems 2, 3 and 4
         {regular(m), damped(m), stages},
         [q](order_prediction& p) {  // local errors O(h^{q+1}), projected O(h^{q+2})
             p.y = q + 1;
             p.z = q;
         }},
        {"Hairer-Lubich-Roche 1989, Theorems 4.3, 4.4 and 4.6 for collocation",  // thesis, Corollary 1
         {regular(m),
          damped(m),
          is_collocation(m),
          {"p > s", decided(m.order > m.stages, "p = " + std::to_string(m.order))}},
         [s = m.stages](order_prediction& p) { p.y = p.z = s; }},
        {"Hairer-Wanner II, Theorem VII.4.9",  // thesis, Theorem 5 and Corollary 2
         {regular(m),
          is_collocation(m),
          stiff(m),
          no_node_at_zero(m),
          last_node_is_one(m),
          {"p > 1", decided(n.B > 1, "p = " + std::to_string(n.B))}},
         [n, s = m.stages](order_prediction& p) {
             p.y = n.B;
             p.z = s;
         }},
        {"Hairer-Lubich-Roche 1989, section 5 (B(p), C(q), D(r), stiffly accurate: y of order min(p, 2q, "
         "q+r+1))",
         {regular(m),
          stiff(m),
          {"B(p), C(q), q >= 1", decided(n.C >= 1 && n.B >= 1, B + ", " + C + ", " + D)}},
         [n](order_prediction& p) {
             p.y = std::min({n.B, 2 * n.C, n.C + n.D + 1});
             p.z = std::min(n.C, *p.y);
         }},
        {"Hairer-Lubich-Roche 1989, section 4, |R(inf)| = 1",
         {regular(m), {"|R(inf)| = 1", decided(modulus(m) == 0, r_text(m))}, stages},
         [q, alternating](order_prediction& p) {  // -1: local errors cancel from step to step
             p.y = alternating ? q + 1 : q;
             p.z = alternating ? q - 1 : q - 2;
             p.note = "for constant step sizes";
         }},
    };
}

}  // namespace detail

/// y' = f(y, z), 0 = g(y, z) with g_z regular: Hairer-Wanner II, Theorem VI.1.1. y has the classical order p;
/// z has p for stiffly accurate methods, min(p, q+1) for -1 <= R(inf) < 1, min(p-1, q) for R(inf) = 1, and
/// diverges for |R(inf)| > 1.
template <class K>
order_prediction predict_index1(const dae_traits<K>& m) {
    const detail::theorem row{
        "Hairer-Wanner II, Theorem VI.1.1",
        {detail::regular(m), detail::of_order_one(m), m.stiff ? detail::stiff(m) : detail::bounded(m)},
        [&m](order_prediction& p) {
            p.y = m.order;
            p.z = m.stiff                 ? m.order
                  : *m.r_infinity == K(1) ? std::min(m.order - 1, m.stage_order)
                                          : std::min(m.order, m.stage_order + 1);
        }};
    return row.applied_or_none();
}
template <class K>
order_prediction predict_index1(const tableau<K>& t) {
    return predict_index1(dae_traits_of(t));
}

/// Every theorem for y' = f(y, z), 0 = g(y) with g_y f_z regular (index 2), with the verdicts on its
/// hypotheses. `condition_order`: how far exact order conditions are looked at (0: not at all).
template <class K>
std::vector<order_prediction> index2_theorems(const tableau<K>& t, int condition_order = 0) {
    const auto m = dae_traits_of(t);
    auto table = detail::index2_table(m);
    if (condition_order > 0) table.push_back(detail::index2_by_conditions(t, m, condition_order));
    std::vector<order_prediction> all;
    for (const auto& row : table) all.push_back(row.applied());
    return all;
}

/// The best of them (largest y order, then z), or "none" with every failing hypothesis.
template <class K>
order_prediction predict_index2(const tableau<K>& t, int condition_order = 0) {
    return detail::best_of(index2_theorems(t, condition_order));
}

/// The same without the order conditions, from what is known of a method.
template <class K>
order_prediction predict_index2(const dae_traits<K>& m) {
    std::vector<order_prediction> all;
    for (const auto& row : detail::index2_table(m)) all.push_back(row.applied());
    return detail::best_of(all);
}

/// y' = f(y, z), z' = k(y, z, u), 0 = g(y) (Hessenberg form of index 3), stiffly accurate collocation with s
/// >= 2: z has order s, u has s - 1 and y at least s (HLR89, section 6). Higher orders of y, up to 2s - 1,
/// are observed for Radau IIA and not promised here.
///
/// For the other families no theorem is known to this library and the prediction is none, with the
/// hypotheses that fail. Orders of (y, z, u) observed with constant steps (tests/orders/index_3.cpp; exact
/// examples where u does not converge: tests/dae_order/index_3_linear.cpp):
///
/// - Gauss, |R(inf)| = 1: (s+1, s-1, s-3) for s = 3, 5, (s, s-2, s-4) for s = 2, 4. What a step leaves over
///   in g is not damped, enters z divided by h and u divided by h^2, and adds up from step to step unless
///   R(inf) = -1. u does not converge for s <= 4, for s = 2 neither does z.
/// - Lobatto IIIA, |R(inf)| = 1 and A singular, which the theorems invert; u_n enters the step by the first
///   stage: (2s-2, s, s-2) for s = 2, 4, (2s-4, s-1, s-3) for s = 3, 5. u does not converge for s = 2, 3.
/// - Lobatto IIIC and Radau IA, no collocation: z has s - 1, u has s - 2.
/// - Lobatto IIIB, A singular: no step can be made.
template <class K>
order_prediction predict_index3(const dae_traits<K>& m) {
    const detail::theorem row{"Hairer-Lubich-Roche 1989, section 6, stiffly accurate collocation",
                              {detail::regular(m),
                               detail::damped(m),
                               detail::is_collocation(m),
                               detail::stiff(m),
                               detail::no_node_at_zero(m),
                               detail::last_node_is_one(m),
                               {"s >= 2", detail::decided(m.stages >= 2, "s = " + std::to_string(m.stages))}},
                              [&m](order_prediction& p) {
                                  p.y = p.z = m.stages;
                                  p.u = m.stages - 1;
                                  p.note = "y: lower bound; up to " + std::to_string(m.simplifying.B) +
                                           " is observed, not promised";
                              }};
    return row.applied_or_none();
}
template <class K>
order_prediction predict_index3(const tableau<K>& t) {
    return predict_index3(dae_traits_of(t));
}

/// y' = f(y, lambda), eps lambda' = g(y, lambda) with mu(g_lambda) <= -1: thesis, Theorem 7
/// (Hairer-Wanner II, Corollary VI.3.10). y: O(h^p) + O(eps h^{q+1}); lambda: O(h^{q+1}), stiffly accurate
/// methods O(h^p) + O(eps h^q).
template <class K>
epsilon_prediction predict_singular_perturbation(const tableau<K>& t) {
    const auto m = dae_traits_of(t);
    epsilon_prediction p;
    p.theorem = "Hairer-Wanner II, Corollary VI.3.10";
    p.hypotheses = {
        {"A-stable", a_stable(stability_function_of(t))},
        {"eigenvalues of A in the right half-plane", eigenvalues_in_right_half_plane(t)},
        detail::damped(m),
        {"p > q", detail::decided(m.order > m.stage_order, "p = " + std::to_string(m.order) +
                                                               ", q = " + std::to_string(m.stage_order))}};
    if (!detail::all_proved(p.hypotheses)) return p;
    p.y = {{0, m.order}, {1, m.stage_order + 1}};
    if (m.stiff) {
        p.lambda = {{0, m.order}, {1, m.stage_order}};
    } else {
        p.lambda = {{0, m.stage_order + 1}};
    }
    return p;
}

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/dae/dae_order-inl.hpp"
#endif
