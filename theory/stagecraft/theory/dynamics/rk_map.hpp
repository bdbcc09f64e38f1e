// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "stagecraft/theory/dynamics/evaluate.hpp"
#include "stagecraft/theory/dynamics/tableau_numbers.hpp"

namespace stagecraft::theory {

/// The map x_0 -> x_1 of a Runge-Kutta method at one step size, solved to rounding: a measuring instrument
/// for large steps, no integrator. Implicit stages by Newton's method with full Jacobians and halved
/// increments where the residual would grow. Nothing where that does not converge or a number is not finite.
template <int N, class F>
std::optional<state<double, N>> rk_step(const tableau<double>& m, F&& f, const state<double, N>& x, double h,
                                        double t = 0) {
    using vector = Eigen::VectorXd;
    const auto s = m.b.size();
    vector k = vector::Zero(s * N);  // h times the slopes
    state<double, N> fi;
    const auto stage = [&](const vector& slopes, Eigen::Index i) {
        state<double, N> xi = x;
        for (Eigen::Index j = 0; j < s; ++j)
            if (m.A(i, j) != 0) xi += m.A(i, j) * slopes.segment<N>(j * N);
        return xi;
    };
    const auto residual = [&](const vector& slopes) {
        vector r(s * N);
        for (Eigen::Index i = 0; i < s; ++i) {
            f(t + m.c[i] * h, stage(slopes, i), fi);
            r.segment<N>(i * N) = slopes.segment<N>(i * N) - h * fi;
        }
        return r;
    };
    if (is_explicit(m)) {
        for (Eigen::Index i = 0; i < s; ++i) {
            f(t + m.c[i] * h, stage(k, i), fi);
            k.segment<N>(i * N) = h * fi;
        }
    } else {
        vector r = residual(k);
        automatic_jacobian<double, N> differentiate(N);
        bool done = false;
        for (int round = 0; round < 200 && !done; ++round) {
            Eigen::MatrixXd J = Eigen::MatrixXd::Identity(s * N, s * N);
            for (Eigen::Index i = 0; i < s; ++i) {
                Eigen::Matrix<double, N, N> fx;
                const state<double, N> xi = stage(k, i);
                differentiate(f, t + m.c[i] * h, xi, xi, fx);
                for (Eigen::Index j = 0; j < s; ++j) J.block<N, N>(i * N, j * N) -= h * m.A(i, j) * fx;
            }
            const vector step = J.partialPivLu().solve(r);
            if (!step.allFinite()) return {};
            double part = 1;
            vector next = k - step, rest = residual(next);
            while (!(rest.norm() < r.norm()) && part > 1e-10) {
                part /= 2;
                next = k - part * step;
                rest = residual(next);
            }
            const double size = x.norm() + k.norm();
            done = step.norm() <= 1e-13 * size || r.norm() == 0;
            if (rest.norm() < r.norm()) {
                k = next;
                r = rest;
            } else if (step.norm() <= 1e-9 * size) {
                done = true;  // only rounding is left
            } else {
                return {};
            }
        }
        if (!done) return {};
    }
    state<double, N> y = x;
    for (Eigen::Index j = 0; j < s; ++j) y += m.b[j] * k.segment<N>(j * N);
    if (!y.allFinite()) return {};
    return y;
}

}  // namespace stagecraft::theory
