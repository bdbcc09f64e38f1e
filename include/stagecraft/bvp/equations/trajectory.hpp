// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace stagecraft::detail {

/// Moves y at the mesh points of x onto the trajectory of y' = f(t, y, p) that begins where x does: eight steps of the classical
/// Runge-Kutta method in an interval, of `nodes` slopes each. Where it leaves a hundred times the size of x, or f is not finite, y
/// stays, and a trajectory begins anew at the end of the interval. Cost: 32 evaluations of f an interval.
template <class Vector, class Functions, class Iterate>
void follow_trajectory(Functions& functions, int nodes, Iterate& x) {
    using scalar = typename Vector::Scalar;
    constexpr int steps = 8, far = 100;
    const int n = functions.size();
    const scalar most = far * (1 + x.y.cwiseAbs().maxCoeff());
    for (int i = 0; i < x.intervals(); ++i) {
        const scalar h = x.h(i) / steps;
        Vector y = x.y.col(i), at = y, sum(n);
        bool near = true;
        for (int k = 0; k < steps && near; ++k) {
            const scalar t = x.t[i] + scalar(k) * h;
            const auto slope = [&](const scalar& part, int weight) {
                const Vector f = functions.f(t + part * h, at, x.p).head(n);
                sum += scalar(weight) * f;
                return f;
            };
            sum.setZero(), at = y;
            at = y + h / 2 * slope(scalar(0), 1);
            at = y + h / 2 * slope(scalar(1) / 2, 2);
            at = y + h * slope(scalar(1) / 2, 2);
            slope(scalar(1), 1);
            y += h / 6 * sum;
            near = y.cwiseAbs().maxCoeff() < most;
        }
        if (near) x.y.col(i + 1) = y;
        for (int j = 0; j < nodes; ++j) x.Z.col(i * nodes + j) = x.y.col(i + 1) - x.y.col(i);
    }
}

}  // namespace stagecraft::detail
