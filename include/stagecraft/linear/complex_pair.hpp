// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/linear/packet.hpp>
#include <stagecraft/linear/split_complex.hpp>

namespace stagecraft {

/// A complex number of each of two matrices, which are worked on together: one instruction does for both what it does for
/// a number of one, and what each waits for is waited for once. (A constructor that initialises would write what is
/// overwritten at once.)
template <class Scalar>
struct complex_pair {
    using lanes = number_per_lane<Scalar, 2>;
    lanes re, im;

    complex_pair() = default;
    explicit complex_pair(const Scalar& x) : re(lanes::all(x)), im(lanes::all(Scalar(0))) {}
    complex_pair(const lanes& x, const lanes& y) : re(x), im(y) {}

    friend complex_pair operator-(const complex_pair& a, const complex_pair& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend complex_pair operator*(const complex_pair& a, const complex_pair& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
};

template <class Scalar>
number_per_lane<Scalar, 2> size_of(const complex_pair<Scalar>& x) {
    return x.re.abs() + x.im.abs();
}
template <class Scalar>
complex_pair<Scalar> inverse_of(const complex_pair<Scalar>& x) {
    complex_pair<Scalar> r;
    for (int l = 0; l < 2; ++l) reciprocal(x.re[l], x.im[l], r.re[l], r.im[l]);
    return r;
}
/// Both are.
template <class Scalar>
bool usable_pivot(const number_per_lane<Scalar, 2>& size) {
    return usable_pivot(size[0]) && usable_pivot(size[1]);
}
/// One of them is.
template <class Scalar>
bool any_positive(const number_per_lane<Scalar, 2>& x) {
    return x[0] > Scalar(0) || x[1] > Scalar(0);
}

}  // namespace stagecraft
