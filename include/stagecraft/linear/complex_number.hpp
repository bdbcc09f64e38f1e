// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <stagecraft/linear/split_complex.hpp>

namespace stagecraft {

/// A complex number with the plain product: std::complex is unspecified for wide types, and its product tests
/// for NaN in every multiplication.
template <class Scalar>
struct complex_number {
    Scalar re{0}, im{0};

    complex_number() = default;
    explicit complex_number(const Scalar& x) : re(x) {}
    complex_number(const Scalar& x, const Scalar& y) : re(x), im(y) {}

    friend complex_number operator+(const complex_number& a, const complex_number& b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend complex_number operator-(const complex_number& a, const complex_number& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend complex_number operator*(const complex_number& a, const complex_number& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
};

/// |x|, or |re| + |im|: what pivots are compared by.
template <class Scalar>
Scalar size_of(const Scalar& x) {
    using std::abs;
    return abs(x);
}
template <class Scalar>
Scalar size_of(const complex_number<Scalar>& x) {
    using std::abs;
    return abs(x.re) + abs(x.im);
}

template <class Scalar>
bool is_zero(const Scalar& x) {
    return x == Scalar(0);
}
template <class Scalar>
bool is_zero(const complex_number<Scalar>& x) {
    return x.re == Scalar(0) && x.im == Scalar(0);
}

/// 1/x.
template <class Scalar>
Scalar inverse_of(const Scalar& x) {
    return Scalar(1) / x;
}
template <class Scalar>
complex_number<Scalar> inverse_of(const complex_number<Scalar>& x) {
    complex_number<Scalar> r;
    reciprocal(x.re, x.im, r.re, r.im);
    return r;
}

}  // namespace stagecraft
