// SPDX-License-Identifier: BSL-1.0
#pragma once

// The first component at both ends: y_0(a) = left, y_0(b) = right.
struct end_values {
    double left, right;
    template <class Y, class R>
    void operator()(const Y& a, const Y& b, R& r) const {
        r[0] = a[0] - left;
        r[1] = b[0] - right;
    }
};
