// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "stagecraft/theory/dae/dae_order.hpp"

namespace stagecraft::theory {

namespace detail {

/// The first stage is the left end of the step, and A without it is regular.
template <class K>
std::vector<hypothesis> left_stage_hypotheses(const tableau<K>& t, const dae_traits<K>& m) {
    const auto s = t.b.size();
    bool left = t.c[0] == K(0);
    for (Eigen::Index j = 0; j < s; ++j) left = left && t.A(0, j) == K(0);
    std::vector<hypothesis> h{
        {"the first stage is the left end", decided(left, left ? "a_1j = 0, c_1 = 0" : "a_1j != 0")}};
    if (!left) return h;
    bool regular = s > 1;
    if (regular) regular = tableaux::inverse<K>(t.A.bottomRightCorner(s - 1, s - 1)).has_value();
    h.push_back({"A is regular without its first row and column",
                 decided(regular, regular ? "det A_r != 0" : "det A_r = 0")});
    h.push_back(stiff(m));
    return h;
}

}  // namespace detail

/// Index 1 with methods whose first stage is the left end of the step, such as Lobatto IIIA: A is singular
/// and predict_index1 does not apply. Where A without that stage is regular and the method is stiffly
/// accurate, consistent values z_n make all stages satisfy g(Y_i, Z_i) = 0: the method is the one for
/// y' = f(y, G(y)), and y and z have the classical order (Hairer-Wanner II, section VI.1, state space form).
template <class K>
order_prediction predict_index1_left_stage(const tableau<K>& t) {
    const auto m = dae_traits_of(t);
    detail::theorem row{"Hairer-Wanner II, section VI.1, state space form",
                        detail::left_stage_hypotheses(t, m),
                        [&m](order_prediction& p) { p.y = p.z = m.order; }};
    row.hypotheses.push_back(detail::of_order_one(m));
    return row.applied_or_none();
}

/// The same for index 2, for collocation methods with c_1 = 0 and c_s = 1 (Lobatto IIIA): y has the order of the
/// quadrature; z has s for -1 <= R(inf) < 1, and s - 1 for R(inf) = 1, where local errors add up
/// (Hairer-Wanner II, Table VII.4.1; Jay, BIT 33, 1993).
template <class K>
order_prediction predict_index2_left_stage(const tableau<K>& t) {
    const auto m = dae_traits_of(t);
    detail::theorem row{"Jay 1993 (Hairer-Wanner II, Table VII.4.1)", detail::left_stage_hypotheses(t, m),
                        [&m](order_prediction& p) {
                            p.y = m.simplifying.B;
                            p.z = *m.r_infinity == K(1) ? m.stages - 1 : m.stages;
                            p.note = "for constant step sizes";
                        }};
    row.hypotheses.push_back(detail::is_collocation(m));
    row.hypotheses.push_back(detail::bounded(m));
    return row.applied_or_none();
}

}  // namespace stagecraft::theory
