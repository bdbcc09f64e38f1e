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

/// Can p be divided by? False for zero, infinity and NaN.
template <class Scalar>
inline bool usable_pivot(const Scalar& size) {
    return size > Scalar(0) && size - size == Scalar(0);
}

}  // namespace stagecraft
