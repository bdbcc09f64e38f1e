// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace stagecraft {

/// J := the derivative of value(x) by central differences, two values per column, with increments of
/// `relative` times max(|x_j|, floor max |x|): cbrt(eps) for a value good to rounding. `moved` is scratch.
template <class Vector, class F, class Matrix>
void central_differences(const Vector& x, Vector& moved, F&& value, const typename Vector::Scalar& relative,
                         Matrix& J,
                         const typename Vector::Scalar& floor = typename Vector::Scalar(1) / 1000) {
    using std::abs;
    using scalar = typename Vector::Scalar;
    if (x.size() == 0) return;
    const scalar least = floor * x.cwiseAbs().maxCoeff();
    moved = x;
    for (Eigen::Index j = 0; j < x.size(); ++j) {
        const scalar own = abs(x[j]), size = own > least ? own : least;
        const scalar step = relative * (size > scalar(0) ? size : scalar(1));
        moved[j] = x[j] + step;
        const auto up = value(moved);
        moved[j] = x[j] - step;
        J.col(j) = (up - value(moved)) / (2 * step);
        moved[j] = x[j];
    }
}

}  // namespace stagecraft
