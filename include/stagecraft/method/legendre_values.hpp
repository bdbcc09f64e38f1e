// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

namespace stagecraft {

/// The shifted Legendre polynomials P_0(x), ..., P_most(x) on [0, 1], by their recurrence.
template <class Scalar>
void legendre_values(const Scalar& x, int most, Scalar* P) {
    const Scalar z = 2 * x - 1;
    P[0] = Scalar(1);
    if (most > 0) P[1] = z;
    for (int k = 1; k < most; ++k)
        P[k + 1] = (Scalar(2 * k + 1) * z * P[k] - Scalar(k) * P[k - 1]) / Scalar(k + 1);
}

/// The same without a division: ratios[k] = k / (k + 1).
template <class Scalar>
void legendre_values(const Scalar& x, int most, const std::vector<Scalar>& ratios, Scalar* P) {
    const Scalar z = 2 * x - 1;
    P[0] = Scalar(1), P[1] = z;
    for (int k = 1; k < most; ++k) P[k + 1] = z * P[k] + ratios[k] * (z * P[k] - P[k - 1]);
}

}  // namespace stagecraft
