// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/stability/symplectic_pair.hpp"

#include <stdexcept>
#include <string>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE verdict symplectic_pair(const legendre_model<tableaux::rational>& first,
                                          const legendre_model<tableaux::rational>& second) {
    using tableaux::rational;
    if (first.w() != second.w()) throw std::invalid_argument("second: has other nodes than the first");
    const auto& a = first.gram_A();
    const auto& a_hat = second.gram_A();
    const int s = first.stages();
    const auto at = [](const auto& m, int i, int j) {
        return j >= m.first_column(i) && j < m.end_column(i) ? m(i, j) : rational(0);
    };
    for (int i = 0; i < s; ++i)
        for (int j = 0; j < s; ++j) {
            const rational left = at(a_hat, i, j) + at(a, j, i) - (i == 0 && j == 0 ? 1 : 0);
            if (left != 0)
                return verdict::refuted("<P" + std::to_string(i) + ", A_hat P" + std::to_string(j) +
                                        "> + <A P" + std::to_string(i) + ", P" + std::to_string(j) +
                                        "> - (b^T P" + std::to_string(i) + ")(b^T P" + std::to_string(j) +
                                        ") = " + left.str());
        }
    return verdict::proved("G A_hat + (G A)^T = e0 e0^T in Legendre coordinates");
}

}  // namespace stagecraft::theory
