// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <sstream>
#include <stagecraft/tableau.hpp>
#include <stagecraft/tableaux/quadratic.hpp>
#include <string>
#include <vector>

namespace rolling_disc {

/// c | A over b as text, columns aligned.
inline std::string print(const stagecraft::tableau<stagecraft::tableaux::quadratic>& t) {
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
