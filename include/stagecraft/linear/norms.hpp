// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

namespace stagecraft {

/// True if the first n components of x are finite.
template <class Vector>
bool all_finite(const Vector& x, int n) {
    typename Vector::Scalar sum(0);
    for (int i = 0; i < n; ++i) sum += x[i] - x[i];
    return sum == typename Vector::Scalar(0);
}

/// The root mean square of x_i w_i over n components, which are all of x; 0 for n = 0. Where the squares overflow it is taken
/// relative to the largest component, so that it is finite whenever the products are; else infinite or NaN.
template <class Vector, class Weights>
typename Vector::Scalar weighted_norm(const Vector& x, const Weights& w, int n) {
    using scalar = typename Vector::Scalar;
    using std::abs;
    using std::sqrt;
    // A size that the compiler knows, told to it: else it warns of iterations beyond it that are never made.
    if constexpr (int(Vector::SizeAtCompileTime) > 0) n = int(Vector::SizeAtCompileTime);
    if (n == 0) return scalar(0);
    scalar sum = scalar(0);
    for (int i = 0; i < n; ++i) {
        const scalar v = x[i] * w[i];
        sum += v * v;
    }
    if (sum - sum == scalar(0)) return sqrt(sum / scalar(n));
    scalar largest = scalar(0);
    for (int i = 0; i < n; ++i) {
        const scalar v = abs(x[i] * w[i]);
        if (!(v - v == scalar(0))) return v;
        if (v > largest) largest = v;
    }
    sum = scalar(0);
    for (int i = 0; i < n; ++i) {
        const scalar v = x[i] * w[i] / largest;
        sum += v * v;
    }
    return largest * sqrt(sum / scalar(n));
}

}  // namespace stagecraft
