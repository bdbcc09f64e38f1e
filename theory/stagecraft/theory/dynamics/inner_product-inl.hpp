// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/inner_product.hpp"

#include <stdexcept>
#include <string>

#include "stagecraft/compiled.hpp"
#include "stagecraft/tableaux/range.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE void require_inner_product(const dense<rational>& G, Eigen::Index n) {
    if (G.rows() != n || G.cols() != n)
        throw std::invalid_argument("G: must be " + std::to_string(n) + " x " + std::to_string(n));
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            if (G(i, j) != G(j, i)) throw std::invalid_argument("G: must be symmetric");
    if (tableaux::diagonalise<rational>(G).inertia().positive != n)
        throw std::invalid_argument("G: must be positive definite");
}

STAGECRAFT_INLINE bool bounds(const rational& gamma, const dense<rational>& G, const dense<rational>& S) {
    dense<rational> D = S;
    for (Eigen::Index i = 0; i < S.size(); ++i) D.data()[i] = gamma * G.data()[i] - S.data()[i];
    return tableaux::diagonalise<rational>(D).inertia().negative == 0;
}

STAGECRAFT_INLINE supremum largest_eigenvalue(const dense<rational>& G, const dense<rational>& S,
                                              const rational& width) {
    rational low = -1, high = 1;
    while (!bounds(high, G, S)) high = 2 * high;
    while (bounds(low, G, S)) low = 2 * low;
    while (high - low > width) {
        const rational c = (low + high) / 2;
        (bounds(c, G, S) ? high : low) = c;
    }
    // low < largest eigenvalue <= high; is the simplest number between them the eigenvalue itself?
    const rational c = tableaux::simplest_between(low, high);
    dense<rational> D = S;
    for (Eigen::Index i = 0; i < S.size(); ++i) D.data()[i] = S.data()[i] - c * G.data()[i];
    if (bounds(c, G, S) && tableaux::determinant<rational>(D) == 0) return {c, c, {}};
    return {low, high, {}};
}

}  // namespace stagecraft::theory
