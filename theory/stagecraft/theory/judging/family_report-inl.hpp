// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/family_report.hpp"

#include <algorithm>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/exact_tableau.hpp"
#include "stagecraft/tableaux/nodal.hpp"

namespace stagecraft::theory {

namespace detail {

STAGECRAFT_INLINE dae_traits<tableaux::rational> family_traits(tableaux::family f, int s,
                                                               const certificate& known) {
    const tableaux::nodal_polynomial w(f, s);
    const auto rule = tableaux::construction_of(f);
    const auto at = [&](int x) { return w.monomial()(tableaux::rational(x)) == 0; };
    dae_traits<tableaux::rational> m;
    m.stages = s;
    const auto limited = [s](int k) { return std::min(k, 2 * s + 1); };
    m.simplifying = {limited(known.simplifying.b), limited(known.simplifying.c),
                     limited(known.simplifying.d)};
    m.order = known.order;
    m.stage_order = std::min(m.simplifying.B, m.simplifying.C);
    m.stiff = known.stiffly_accurate.is_proved();
    m.r_infinity = known.r_infinity;
    m.collocation = rule == tableaux::construction::collocation;
    if (at(0)) m.zero_node = 0;
    m.ends_at_one = at(1);
    m.last_node = m.ends_at_one ? "1" : "below 1";
    // The node 0 makes the first row of collocation 0; the node 1 the last column of an adjoint method.
    m.regular = rule == tableaux::construction::lobatto_iiic || !at(m.collocation ? 0 : 1);
    m.left_stage = !m.regular && m.collocation;  // the rest of A is regular: its nodes are not 0
    return m;
}

}  // namespace detail

STAGECRAFT_INLINE std::vector<report_section> stability_report(tableaux::family f, int s) {
    if (const auto t = tableaux::exact_tableau(f, s)) return stability_report(*t);
    const auto known = certify(f, s);
    const auto m = detail::family_traits(f, s, known);
    return {{"stability function", function_claims(known.R)},
            {"tableau",
             {{"stiffly accurate", known.stiffly_accurate},
              {"A regular", detail::regular(m).verdict},
              {"algebraically stable", known.algebraically_stable},
              {"B-stable", known.b_stable},
              {"symplectic", known.symplectic},
              {"symmetric", known.symmetric}}},
            {"differential-algebraic problems",
             {detail::prediction_claim("index 1", predict_index1(m)),
              detail::prediction_claim("index 2", predict_index2(m)),
              detail::prediction_claim("index 3", predict_index3(m))}}};
}

}  // namespace stagecraft::theory
