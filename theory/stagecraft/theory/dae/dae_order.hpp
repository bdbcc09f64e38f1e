// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stagecraft/theory/dae/dae_traits.hpp"
#include "stagecraft/theory/dae/index2_conditions.hpp"
#include "stagecraft/theory/stability/a_stability.hpp"

namespace stagecraft::theory {

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

namespace detail {

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

/// What holds for index 2 where the first stage is the left end of the step. Collocation with c_s = 1 (Lobatto IIIA): y has the
/// order of the quadrature; z has s for -1 <= R(inf) < 1, and s - 1 for R(inf) = 1, where local errors add up. Other methods, of
/// which ESDIRK methods are most: an error of z_n comes back as R(inf) times it, and is h^2 times it in y.
template <class K>
std::vector<theorem> index2_left_table(const dae_traits<K>& m) {
    const bool known = m.left_index2.has_value();
    const hypothesis looked{"the conditions are looked at",
                            decided(known, known ? "up to order " + std::to_string(m.left_index2->searched)
                                                 : "the tableau is not at hand")};
    return {{"Jay 1993 (Hairer-Wanner II, Table VII.4.1)",
             {left_end(), stiff(m), is_collocation(m), bounded(m)},
             [&m](order_prediction& p) {
                 p.y = m.simplifying.B;
                 p.z = *m.r_infinity == K(1) ? m.stages - 1 : m.stages;
                 p.note = "for constant step sizes";
             }},
            {"order conditions of index 2 with z_n as the first stage (Hairer-Lubich-Roche 1989, section 5; "
             "Jay 1993)",
             {left_end(), stiff(m), damped(m), looked},
             [&m](order_prediction& p) {
                 const auto& n = *m.left_index2;
                 p.y = std::min({n.y + 1, n.projected, n.z + 2});
                 p.z = std::min(n.z + 1, *p.y);
             }}};
}

template <class K>
std::vector<theorem> index2_table_of(const dae_traits<K>& m) {
    return m.left_stage ? index2_left_table(m) : index2_table(m);
}

}  // namespace detail

/// y' = f(y, z), 0 = g(y, z) with g_z regular: Hairer-Wanner II, Theorem VI.1.1. y has the classical order p;
/// z has p for stiffly accurate methods, min(p, q+1) for -1 <= R(inf) < 1, min(p-1, q) for R(inf) = 1, and
/// diverges for |R(inf)| > 1. Where A is singular because the first stage is the left end of the step, as of Lobatto IIIA and
/// ESDIRK methods, and the method is stiffly accurate, consistent values z_n make all stages satisfy g(Y_i, Z_i) = 0: it
/// is the method for y' = f(y, G(y)), and both have the classical order (Hairer-Wanner II, section VI.1, state space form).
template <class K>
order_prediction predict_index1(const dae_traits<K>& m) {
    if (m.left_stage)
        return detail::theorem{"Hairer-Wanner II, section VI.1, state space form",
                               {detail::left_end(), detail::stiff(m), detail::of_order_one(m)},
                               [&m](order_prediction& p) { p.y = p.z = m.order; }}
            .applied_or_none();
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
    auto table = detail::index2_table_of(m);
    if (condition_order > 0 && !m.left_stage)
        table.push_back(detail::index2_by_conditions(t, m, condition_order));
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
    for (const auto& row : detail::index2_table_of(m)) all.push_back(row.applied());
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
