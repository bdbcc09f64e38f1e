// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "stagecraft/theory/dynamics/lyapunov.hpp"

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

}  // namespace stagecraft::theory
