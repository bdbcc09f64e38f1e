// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stagecraft/tableaux/decimals.hpp>
#include <stagecraft/tableaux/entry.hpp>
#include <stagecraft/tableaux/exact_tableau.hpp>
#include <stagecraft/tableaux/polynomial_text.hpp>
#include <stagecraft/theory/judging/certificate_json.hpp>
#include <stagecraft/theory/judging/certify.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The collocation method on given nodes, as `collocate` reads and writes it.
namespace stagecraft::tool {

inline constexpr int most_nodes = 30;
/// Decimals of at most two digits are exact nodes, as they are in a file that has no longer ones.
inline constexpr tableaux::exact_decimals short_decimals{2, 2};

/// Product of x - c over the nodes c, which may be surds as long as it has rational coefficients (conjugates
/// come together).
inline tableaux::nodal_polynomial nodes_from_list(const std::string& list) {
    using poly = tableaux::polynomial<tableaux::quadratic>;
    poly w(tableaux::quadratic(1));
    std::istringstream nodes(list);
    int count = 0;
    for (std::string text; std::getline(nodes, text, ',');) {
        tableaux::entry c;
        try {
            c = tableaux::read_entry(text, short_decimals);
        } catch (const std::invalid_argument& e) {
            throw std::invalid_argument("--nodes: '" + text + "' " + e.what());
        }
        if (!c.exact)
            throw std::invalid_argument("--nodes: '" + text +
                                        "' is not exact: a rounded node is another method; give " +
                                        "a fraction, a surd or --polynomial");
        if (*c.exact < tableaux::quadratic(0) || *c.exact > tableaux::quadratic(1))
            throw std::invalid_argument("--nodes: must lie in [0, 1], one of them is " + text);
        if (++count > most_nodes)
            throw std::invalid_argument("--nodes: more than " + std::to_string(most_nodes));
        try {
            if (w(*c.exact) == tableaux::quadratic(0))
                throw std::invalid_argument("--nodes: must be distinct, " + text + " is repeated");
            w *= poly{-*c.exact, tableaux::quadratic(1)};
        } catch (const tableaux::mixed_surds&) {
            throw std::invalid_argument("--nodes: three independent surds; give --polynomial");
        }
    }
    if (count == 0) throw std::invalid_argument("--nodes: at least one node needed");
    std::vector<tableaux::rational> coefficients;
    for (const auto& k : w.coefficients()) {
        if (!k.is_rational())
            throw std::invalid_argument("--nodes: the product of x - c has the irrational coefficient " +
                                        k.str() + "; a surd needs its conjugate");
        coefficients.push_back(k.rational_part());
    }
    return tableaux::nodal_polynomial::from_coefficients(std::move(coefficients), "given nodes");
}

inline tableaux::nodal_polynomial nodes_from_polynomial(const std::string& text) {
    try {
        const auto w = tableaux::read_polynomial(text);
        if (w.degree() > most_nodes)
            throw std::invalid_argument("the degree exceeds " + std::to_string(most_nodes));
        return tableaux::nodal_polynomial::from_coefficients(w.coefficients(), "roots of " + to_string(w));
    } catch (const std::invalid_argument& e) {
        throw std::invalid_argument("--polynomial: " + std::string(e.what()));
    }
}

/// The tableau in surds where the nodes lie in a quadratic field, otherwise to 30 digits.
inline tableaux::decimal_tableau written(const tableaux::nodal_polynomial& w) {
    constexpr auto rule = tableaux::construction::collocation;
    if (const auto exact = tableaux::exact_tableau(w, rule))
        return tableaux::rounding::texts(*exact, [](const tableaux::quadratic& x) { return x.str(); });
    return tableaux::decimals(w, rule, 30);
}

/// What `collocate --json` prints; "tableau" in it is a file that `certify` reads.
inline nlohmann::ordered_json to_json(const tableaux::nodal_polynomial& w, const tableaux::decimal_tableau& t,
                                      const theory::certificate& certificate) {
    nlohmann::ordered_json out;
    out["tableau"] = {{"name", "collocation at the roots of " + to_string(w.monomial())},
                      {"c", t.c},
                      {"A", t.A},
                      {"b", t.b},
                      {"claims", {{"order", std::min(certificate.order, 14)}}}};
    out["certificate"] = theory::to_json(certificate);
    return out;
}

}  // namespace stagecraft::tool
