// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/sum_of_squares.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory::detail {

STAGECRAFT_INLINE bool is_sum_of_squares(const multinomial& p, int unknowns) {
    using monomial = std::vector<int>;
    const auto padded = [&](multinomial::monomial m) {
        m.resize(static_cast<std::size_t>(unknowns), 0);
        return m;
    };
    std::set<monomial> halves;
    for (const auto& [m, a] : p.terms()) {
        monomial h = padded(m);
        bool even = true;
        for (int& k : h) {
            even = even && k % 2 == 0;
            k /= 2;
        }
        if (even) halves.insert(h);
    }
    const std::vector<monomial> z(halves.begin(), halves.end());
    std::map<monomial, std::vector<std::pair<Eigen::Index, Eigen::Index>>> places;
    for (std::size_t i = 0; i < z.size(); ++i) {
        for (std::size_t j = 0; j < z.size(); ++j) {
            monomial m = z[i];
            for (std::size_t k = 0; k < m.size(); ++k) m[k] += z[j][k];
            places[m].emplace_back(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
    }
    dense<rational> S = dense<rational>::Constant(static_cast<Eigen::Index>(z.size()),
                                                  static_cast<Eigen::Index>(z.size()), rational(0));
    for (const auto& [m, a] : p.terms()) {
        const auto where = places.find(padded(m));
        if (where == places.end()) return false;
        // an even monomial goes to the diagonal
        std::vector<std::pair<Eigen::Index, Eigen::Index>> chosen;
        for (const auto& place : where->second)
            if (place.first == place.second) chosen.push_back(place);
        if (chosen.empty()) chosen = where->second;
        for (const auto& [i, j] : chosen) S(i, j) += a / rational(static_cast<int>(chosen.size()));
    }
    return z.empty() ? p.is_zero() : tableaux::diagonalise<rational>(S).inertia().negative == 0;
}

}  // namespace stagecraft::theory::detail
