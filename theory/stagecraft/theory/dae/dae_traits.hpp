// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "stagecraft/method/order_conditions.hpp"
#include "stagecraft/theory/dae/index2_conditions.hpp"
#include "stagecraft/theory/stability/algebraic_stability.hpp"

namespace stagecraft::theory {

/// A hypothesis of a theorem and the verdict on it for the method at hand.
struct hypothesis {
    std::string name;
    theory::verdict verdict;
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
    /// The first stage is the left end of the step, and A is regular without its first row and column: methods such as
    /// Lobatto IIIA, and ESDIRK methods.
    bool left_stage = false;
    std::optional<index2_local_orders> left_index2;  ///< of a stiffly accurate one, where they were looked at
};

/// How far the conditions of index 2 are looked at for methods whose first stage is the left end of the step.
inline constexpr int largest_left_index2_order = 6;

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
    if (m.regular) return m;
    const auto rest = left_stage_inverse(t);
    m.left_stage = rest.has_value();
    if (m.left_stage && m.stiff && m.order > 0)
        m.left_index2 =
            index2_local_orders_of(t, *rest, std::min(m.order, largest_left_index2_order), std::equal_to<>{});
    return m;
}

namespace detail {

verdict decided(bool holds, std::string text);

template <class K>
hypothesis regular(const dae_traits<K>& m) {
    return {"A is regular", decided(m.regular, m.regular ? "det A != 0" : "det A = 0")};
}
/// In place of a regular A.
hypothesis left_end();

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

}  // namespace detail

}  // namespace stagecraft::theory
