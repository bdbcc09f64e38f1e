// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/judging/certificate.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE stagecraft::facts certificate::facts() const {
    stagecraft::facts f;
    f.order = order;
    f.stage_order = simplifying.stage_order();
    f.a_stable = a_stable.is_proved();
    f.algebraically_stable = algebraically_stable.is_proved();
    f.symplectic = symplectic.is_proved();
    f.symmetric = symmetric.is_proved();
    f.r_infinity = r_infinity ? r_infinity->to<double>() : std::numeric_limits<double>::quiet_NaN();
    return f;
}

STAGECRAFT_INLINE std::vector<claim> certificate::claims() const {
    std::vector<claim> all{{"order " + std::to_string(order), order_verdict}};
    all.insert(all.end(), others.begin(), others.end());
    const auto add = [&](std::string statement, const theory::verdict& v) {
        all.push_back({std::move(statement), v});
    };
    add("A-stable", a_stable);
    add("L-stable", l_stable);
    add("algebraically stable", algebraically_stable);
    add("B-stable", b_stable);
    add("symplectic", symplectic);
    add("symmetric", symmetric);
    add("stiffly accurate", stiffly_accurate);
    return all;
}

STAGECRAFT_INLINE std::string certificate::text() const {
    std::string out = method + ", " + std::to_string(stages) + (stages == 1 ? " stage\n" : " stages\n");
    const auto all = claims();
    std::size_t width = 0;
    for (const claim& c : all)
        if (c.statement.size() <= 40) width = std::max(width, c.statement.size());
    for (const claim& c : all) {
        out += "  " + c.statement;
        if (c.statement.size() <= width) out += std::string(width - c.statement.size(), ' ');
        out += "  " + c.verdict.text() + "\n";
    }
    if (!spectra.note.empty()) out += "  " + spectra.note + "\n";
    return out;
}

}  // namespace stagecraft::theory
