// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/lyapunov.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "stagecraft/compiled.hpp"

namespace stagecraft::theory {

STAGECRAFT_INLINE double attraction::euclidean_radius() const {
    // x^T G x <= trace(G) |x|^2
    interval trace = 0;
    for (Eigen::Index i = 0; i < G.rows(); ++i) trace += interval(G(i, i));
    return (interval(radius) / sqrt(trace)).low();
}

STAGECRAFT_INLINE double perron_rate(const rational& gamma, const dense<rational>& G,
                                     const rational& epsilon) {
    require_inner_product(G, G.rows());
    if (epsilon < 0) throw std::invalid_argument("epsilon: must not be negative, is " + epsilon.str());
    const auto one = tableaux::identity<rational>(G.rows());
    // 1/eta_1^2 is the largest eigenvalue of 1 - x G.
    const rational quotient = largest_eigenvalue(one, G).high * largest_eigenvalue(G, one).high;
    return (interval(gamma) + interval(epsilon) * sqrt(interval(quotient))).high();
}

}  // namespace stagecraft::theory
