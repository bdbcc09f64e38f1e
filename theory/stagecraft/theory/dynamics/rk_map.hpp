// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/evaluate.hpp"
#include "stagecraft/theory/dynamics/tableau_numbers.hpp"

namespace stagecraft::theory {

namespace detail {

/// The h k_i of one step of a method with stages Y_i = x + sum_j a_ij (h k_j), below one another.
template <int N, class F>
class stage_slopes {
  public:
    stage_slopes(const tableau<double>& m, F& f, const state<double, N>& x, double h, double t)
        : m_(m), f_(f), x_(x), h_(h), t_(t), s_(m.b.size()) {}

    /// One stage after the other, from zero: for explicit methods.
    Eigen::VectorXd in_turn() {
        Eigen::VectorXd k = Eigen::VectorXd::Zero(s_ * N);
        for (Eigen::Index i = 0; i < s_; ++i) k.segment<N>(i * N) = slope(k, i);
        return k;
    }

    /// All at once, by Newton's method from zero; nothing where it does not converge.
    std::optional<Eigen::VectorXd> at_once() {
        using vector = Eigen::VectorXd;
        vector k = vector::Zero(s_ * N), r = residual(k);
        for (int round = 0; round < 200; ++round) {
            const vector step = jacobian(k).partialPivLu().solve(r);
            if (!step.allFinite()) return {};
            double part = 1;
            vector next = k - step, rest = residual(next);
            while (!(rest.norm() < r.norm()) && part > 1e-10) {
                part /= 2;
                next = k - part * step;
                rest = residual(next);
            }
            const double size = x_.norm() + k.norm();
            const bool done = step.norm() <= 1e-13 * size || r.norm() == 0;
            if (rest.norm() < r.norm()) {
                k = next;
                r = rest;
                if (done) return k;
            } else if (done || step.norm() <= 1e-9 * size) {
                return k;  // only rounding is left
            } else {
                return {};
            }
        }
        return {};
    }

    /// Y_i for given h k_j.
    state<double, N> stage(const Eigen::VectorXd& slopes, Eigen::Index i) const {
        state<double, N> xi = x_;
        for (Eigen::Index j = 0; j < s_; ++j)
            if (m_.A(i, j) != 0) xi += m_.A(i, j) * slopes.segment<N>(j * N);
        return xi;
    }

  private:
    state<double, N> slope(const Eigen::VectorXd& slopes, Eigen::Index i) {
        state<double, N> fi;
        f_(t_ + m_.c[i] * h_, stage(slopes, i), fi);
        return h_ * fi;
    }
    Eigen::VectorXd residual(const Eigen::VectorXd& slopes) {
        Eigen::VectorXd r(s_ * N);
        for (Eigen::Index i = 0; i < s_; ++i)
            r.segment<N>(i * N) = slopes.segment<N>(i * N) - slope(slopes, i);
        return r;
    }
    Eigen::MatrixXd jacobian(const Eigen::VectorXd& slopes) {
        Eigen::MatrixXd J = Eigen::MatrixXd::Identity(s_ * N, s_ * N);
        for (Eigen::Index i = 0; i < s_; ++i) {
            Eigen::Matrix<double, N, N> fx;
            const state<double, N> xi = stage(slopes, i);
            differentiate_(f_, t_ + m_.c[i] * h_, xi, xi, fx);
            for (Eigen::Index j = 0; j < s_; ++j) J.block<N, N>(i * N, j * N) -= h_ * m_.A(i, j) * fx;
        }
        return J;
    }

    const tableau<double>& m_;
    F& f_;
    const state<double, N>& x_;
    double h_, t_;
    Eigen::Index s_;
    automatic_jacobian<double, N> differentiate_{N};
};

}  // namespace detail

/// One step with what it is made of: x_1 = x_0 + h phi(x_0, t, h), phi the increment function (lecture, Definition 2.2), and
/// the stages X_i.
template <int N>
struct step_parts {
    state<double, N> end, increment;
    std::vector<state<double, N>> stages;
};

/// The map x_0 -> x_1 of a Runge-Kutta method at one step size, solved to rounding: a measuring instrument
/// for large steps, no integrator. Implicit stages by Newton's method with full Jacobians and halved
/// increments where the residual would grow. Nothing where that does not converge or a number is not finite. Throws
/// std::invalid_argument for h = 0, which has no increment.
template <int N, class F>
std::optional<step_parts<N>> rk_parts(const tableau<double>& m, F&& f, const state<double, N>& x, double h,
                                      double t = 0) {
    if (h == 0) throw std::invalid_argument("h: must not be 0");
    detail::stage_slopes<N, std::remove_reference_t<F>> slopes(m, f, x, h, t);
    const auto k = is_explicit(m) ? std::optional(slopes.in_turn()) : slopes.at_once();
    if (!k) return {};
    step_parts<N> parts{x, state<double, N>::Zero(), {}};
    for (Eigen::Index j = 0; j < m.b.size(); ++j) {
        parts.end += m.b[j] * k->template segment<N>(j * N);
        parts.increment += m.b[j] / h * k->template segment<N>(j * N);
        parts.stages.push_back(slopes.stage(*k, j));
    }
    if (!parts.end.allFinite()) return {};
    return parts;
}

/// Its end alone; h = 0 gives x.
template <int N, class F>
std::optional<state<double, N>> rk_step(const tableau<double>& m, F&& f, const state<double, N>& x, double h,
                                        double t = 0) {
    if (h == 0) return x;
    auto parts = rk_parts<N>(m, f, x, h, t);
    if (!parts) return {};
    return std::move(parts->end);
}

}  // namespace stagecraft::theory
