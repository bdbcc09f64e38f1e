// SPDX-License-Identifier: BSL-1.0
#include "embedded_collocation.hpp"

#include <algorithm>
#include <stagecraft/tableaux/correct_rounding.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/roots.hpp>
#include <stagecraft/theory/stability/embedded_collocation.hpp>
#include <stdexcept>
#include <utility>

namespace stagecraft::tool {

namespace {

constexpr int digits = 30;

std::string decimals(const tableaux::ball& x) {
    auto text = tableaux::decimal_text(x, digits);
    if (!text) throw tableaux::undecided("round: an embedded weight is undecided to 30 digits");
    return *std::move(text);
}

std::vector<std::string> written(const tableaux::nodal_polynomial& w,
                                 const theory::embedded_weights_of_nodes& e) {
    std::vector<std::string> b;
    if (const auto nodes = tableaux::exact_nodes(w)) {
        const auto weights = theory::weights_at(e.moments, *nodes);
        for (Eigen::Index i = 0; i < weights.size(); ++i) b.push_back(weights[i].str());
    } else {
        const int start = tableaux::working_bits(tableaux::bits_for_digits(digits), w);
        b = tableaux::widening(start, [&](int bits) {
            std::vector<std::string> all;
            for (const auto& x : theory::weights_at(e.moments, tableaux::enclose_nodes(w, bits), bits))
                all.push_back(decimals(x));
            return all;
        });
    }
    if (e.at_zero) b.insert(b.begin(), e.at_zero->str());
    return b;
}

embedded_method method_of(const tableaux::nodal_polynomial& w, const theory::embedded_weights_of_nodes& e,
                          bool l_stable) {
    return {written(w, e), e.at_zero.has_value(), e.order, l_stable, e.why};
}

}  // namespace

std::optional<embedded_method> embedded_of(const tableaux::nodal_polynomial& w, const std::string& kind,
                                           std::string& said) {
    if (kind == "highest") {
        if (const auto e = theory::highest_embedded(w)) return method_of(w, *e, false);
        said = "there is no embedded formula of order 1 or more: the stages have no other weights of order 1";
        return {};
    }
    if (kind != "l-stable")
        throw std::invalid_argument("--embedded: unknown '" + kind + "', allowed: highest, l-stable");
    auto found = theory::l_stable_embedded(w);
    if (found.weights) return method_of(w, *found.weights, true);
    said = std::move(found.none);
    return {};
}

tableaux::decimal_tableau with_stage(tableaux::decimal_tableau t, const embedded_method& e) {
    if (!e.extra_stage) return t;
    for (auto& row : t.A) row.insert(row.begin(), "0");
    t.A.insert(t.A.begin(), std::vector<std::string>(t.b.size() + 1, "0"));
    t.b.insert(t.b.begin(), "0");
    t.c.insert(t.c.begin(), "0");
    return t;
}

nlohmann::ordered_json file_of(const tableaux::decimal_tableau& t, const embedded_method& e,
                               const std::string& name) {
    nlohmann::ordered_json claims{{"order", std::min(e.order, 14)}};
    if (e.l_stable) claims["L_stable"] = true;
    return {{"name", "embedded method of " + name}, {"c", t.c}, {"A", t.A}, {"b", e.b}, {"claims", claims}};
}

}  // namespace stagecraft::tool
