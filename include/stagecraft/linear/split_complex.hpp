// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

namespace stagecraft {

/// 1/(x + i y) by Smith's formula, which neither overflows nor underflows where the result does not. Complex
/// numbers are kept as two reals: std::complex is unspecified for wide types, and its product tests for NaN.
template <class Scalar>
inline void reciprocal(const Scalar& x, const Scalar& y, Scalar& re, Scalar& im) {
    using std::abs;
    if (abs(x) >= abs(y)) {
        const Scalar q = y / x;
        const Scalar d = Scalar(1) / (x + y * q);
        re = d;
        im = -q * d;
    } else {
        const Scalar q = x / y;
        const Scalar d = Scalar(1) / (x * q + y);
        re = q * d;
        im = -d;
    }
}

/// |x + i y| where the squares neither overflow nor underflow to matter; infinite or NaN only if x or y is.
template <class Scalar>
inline Scalar modulus(const Scalar& x, const Scalar& y) {
    using std::abs;
    using std::sqrt;
    const Scalar a = abs(x), b = abs(y), large = a < b ? b : a, small = a < b ? a : b;
    if (!(large > Scalar(0)) || !(large - large == Scalar(0))) return large + small;
    const Scalar q = small / large;
    return large * sqrt(Scalar(1) + q * q);
}

/// Can p be divided by? False for zero, infinity and NaN.
template <class Scalar>
inline bool usable_pivot(const Scalar& size) {
    return size > Scalar(0) && size - size == Scalar(0);
}

}  // namespace stagecraft
