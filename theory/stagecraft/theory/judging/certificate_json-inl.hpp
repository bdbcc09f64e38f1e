// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/certificate_json.hpp"

#include <string>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE nlohmann::ordered_json to_json(const certificate& c) {
    using nlohmann::ordered_json;
    const auto polynomial = [](const auto& p) {
        ordered_json a = ordered_json::array();
        for (const auto& coefficient : p.coefficients()) a.push_back(coefficient.str());
        return a;
    };
    const auto condition = [](int k) { return k == every ? ordered_json("infinity") : ordered_json(k); };
    const auto inertia = [](const tableaux::inertia& n) {
        return ordered_json{{"positive", n.positive}, {"negative", n.negative}, {"zero", n.zero}};
    };
    ordered_json order = to_json(c.order_verdict);
    order["value"] = c.order;
    ordered_json j{
        {"method", c.method},
        {"stages", c.stages},
        {"order", order},
        {"B", condition(c.simplifying.b)},
        {"C", condition(c.simplifying.c)},
        {"D", condition(c.simplifying.d)},
        {"stage_order", c.simplifying.stage_order()},
        {"R_infinity", c.r_infinity ? c.r_infinity->str() : "infinity"},
        {"A_stable", to_json(c.a_stable)},
        {"L_stable", to_json(c.l_stable)},
        {"algebraically_stable", to_json(c.algebraically_stable)},
        {"B_stable", to_json(c.b_stable)},
        {"symplectic", to_json(c.symplectic)},
        {"symmetric", to_json(c.symmetric)},
        {"stiffly_accurate", to_json(c.stiffly_accurate)},
        {"error_constant", c.error_constant.str()},
        {"b_inertia", inertia(c.weights)},
        {"M_inertia", inertia(c.M)},
        {"stability_function",
         {{"numerator", polynomial(c.R.numerator)}, {"denominator", polynomial(c.R.denominator)}}},
    };
    if (c.principal_error) j["principal_error"] = to_json(*c.principal_error);
    add_to_json(c.spectra, j);
    ordered_json claims = ordered_json::array();
    for (const claim& entry : c.claims()) {
        ordered_json e{{"statement", entry.statement}};
        e.update(to_json(entry.verdict));
        claims.push_back(e);
    }
    j["claims"] = claims;
    return j;
}

}  // namespace stagecraft::theory
