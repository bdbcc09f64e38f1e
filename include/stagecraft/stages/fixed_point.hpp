// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/linear/norms.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/stages/stage_slopes.hpp>

namespace stagecraft {

/// The stage equations by fixed point iteration, k_i <- f(t + c_i h, y + h sum_j a_ij k_j) for all stages at once:
/// no Jacobian and no linear system, s evaluations of f an iteration. It converges where h L |A|_inf < 1, L a
/// Lipschitz constant of f, and for linear problems where h |lambda| rho(A) < 1 for every eigenvalue (Hairer-Wanner
/// II.IV.8; for stiff problems, then, only at the step sizes of explicit methods). M = I.
template <class Vector, int Stages, class Blocks>
class fixed_point_stages {
  public:
    using slopes = stage_slopes<Vector, Stages, Blocks>;
    using scalar = typename Vector::Scalar;

    explicit fixed_point_stages(int n) : n_(n), stage_(n), value_(n) {}

    /// Computes the slopes, from a first guess in v.k; Z takes z_i = Y_i - y in its columns. The iteration ends
    /// where the error left in the z_i is below limits.factor, judged by the contraction that is seen.
    template <class System, class Norm, class StageMatrix>
    newton_outcome<scalar> solve(System& system, const scalar& t, const Vector& y, const scalar& h,
                                 const Norm& norm, const newton_limits<scalar>& limits, slopes& v,
                                 StageMatrix& Z) {
        const auto& m = v.method;
        const int s = m.stages();
        newton_limits<scalar> told = limits;
        told.affine = false;
        told.patience = limits.iterations;  // with complex eigenvalues increments need not fall at once
        newton_monitor<scalar> monitor(told);
        const auto stage = [&](int i) { v.combine([&](int j) { return m.A(i, j); }, s, h, stage_); };
        for (int i = 0; i < s; ++i) {
            stage(i);
            Z.col(i) = stage_;
        }
        while (monitor.may_go_on()) {
            for (int i = 0; i < s; ++i) {
                stage_ = y + Z.col(i);
                system(t + m.c[i] * h, stage_, value_);
                v.k.col(i) = value_;
            }
            scalar largest(0);
            for (int i = 0; i < s; ++i) {
                stage(i);
                value_ = stage_ - Z.col(i);
                const scalar size = norm(value_);
                if (!(size <= largest)) largest = size;
                Z.col(i) = stage_;
            }
            if (monitor.over(largest)) break;
        }
        if (monitor.outcome().end != newton_end::converged) v.k.setZero();
        return monitor.outcome();
    }

  private:
    int n_;
    Vector stage_, value_;
};

}  // namespace stagecraft
