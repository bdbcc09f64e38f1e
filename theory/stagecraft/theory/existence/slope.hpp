// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>

namespace stagecraft::theory {

/// A number and its derivative in one direction.
template <class K>
struct slope {
    K value, rate;

    slope() = default;
    template <std::integral I>
    explicit slope(I n) : value(n), rate(0) {}
    slope(K v, K r) : value(v), rate(r) {}

    friend slope operator+(const slope& x, const slope& y) { return {x.value + y.value, x.rate + y.rate}; }
    friend slope operator-(const slope& x, const slope& y) { return {x.value - y.value, x.rate - y.rate}; }
    friend slope operator*(const slope& x, const slope& y) {
        return {x.value * y.value, x.rate * y.value + x.value * y.rate};
    }
};

}  // namespace stagecraft::theory
