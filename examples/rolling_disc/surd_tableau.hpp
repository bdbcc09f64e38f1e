// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <sstream>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <stagecraft/tableaux/polynomial.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rolling_disc {

using stagecraft::tableaux::quadratic;
using stagecraft::tableaux::rational;

/// The roots of w exactly, increasing, where at most two of them are irrational: 0, 1/2 and 1 are split off,
/// the rest is a linear or quadratic equation. Throws std::domain_error for any other w.
inline std::vector<quadratic> exact_nodes(const stagecraft::tableaux::nodal_polynomial& w) {
    using stagecraft::tableaux::polynomial;
    polynomial<rational> rest = w.monomial();
    std::vector<quadratic> nodes;
    for (const rational& node : {rational(0), rational(1, 2), rational(1)})
        if (rest(node) == 0) {
            nodes.emplace_back(node);
            rest = rest / polynomial<rational>{-node, 1};
        }
    if (rest.degree() == 1) nodes.emplace_back(-rest[0] / rest[1]);
    if (rest.degree() == 2) {
        const auto root = exact_sqrt(rest[1] * rest[1] - 4 * rest[0] * rest[2]);
        if (root)
            for (const int side : {-1, 1})
                nodes.push_back((quadratic(-rest[1]) + quadratic(side) * *root) / quadratic(2 * rest[2]));
    }
    if (static_cast<int>(nodes.size()) != w.degree())
        throw std::domain_error("exact_nodes: the nodes of " + w.name() +
                                " do not lie in one quadratic field");
    std::sort(nodes.begin(), nodes.end(), [](const quadratic& a, const quadratic& b) { return a < b; });
    return nodes;
}

/// c | A over b as text, columns aligned.
inline std::string print(const stagecraft::tableau<quadratic>& t) {
    const int s = t.stages();
    const auto cell = [&](int i, int j) {
        return j < 0 ? (i < s ? t.c(i).str() : std::string()) : i < s ? t.A(i, j).str() : t.b(j).str();
    };
    std::vector<std::size_t> width(s + 1, 0);
    for (int j = -1; j < s; ++j)
        for (int i = 0; i <= s; ++i) width[j + 1] = std::max(width[j + 1], cell(i, j).size());
    std::ostringstream out;
    for (int i = 0; i <= s; ++i) {
        if (i == s) {
            out << "  " << std::string(width[0], '-') << "-+";
            for (int j = 0; j < s; ++j) out << std::string(width[j + 1] + 2, '-');
            out << '\n';
        }
        for (int j = -1; j < s; ++j) {
            const std::string text = cell(i, j);
            out << "  " << std::string(width[j + 1] - text.size(), ' ') << text << (j < 0 ? " |" : "");
        }
        out << '\n';
    }
    return out.str();
}

}  // namespace rolling_disc
