// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/norms.hpp>

namespace stagecraft {

/// A first step size: one that changes the solution by about one per cent in the weighted norm, and at most a
/// thousandth of the span if the solution hardly moves. f is scaled to a derivative by the rows of M;
/// algebraic equations do not enter. The error test corrects a bad guess.
template <class Mass, class Vector>
typename Vector::Scalar first_step(const Mass& mass, const Vector& y, const Vector& f, const Vector& weights,
                                   const typename Vector::Scalar& span) {
    using scalar = typename Vector::Scalar;
    using std::abs;
    const int n = static_cast<int>(y.size());
    if (n == 0) return span;
    Vector slope = f;
    if constexpr (!Mass::identity) {
        Vector row = Vector::Zero(n);
        for (const auto& e : mass.entries())
            if (abs(e.value) > row[e.row]) row[e.row] = abs(e.value);
        for (int i = 0; i < n; ++i) slope[i] = row[i] > scalar(0) ? scalar(f[i] / row[i]) : scalar(0);
    }
    scalar size = weighted_norm(y, weights, n);
    const scalar change = weighted_norm(slope, weights, n);
    if (size < scalar(1)) size = scalar(1);
    return change * span > size / 1000 ? scalar(size / change / scalar(100)) : scalar(span / 1000);
}

}  // namespace stagecraft
