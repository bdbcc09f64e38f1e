// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace stagecraft {

/// Whether f may have jumped between f0 and f, whose arguments differ by rounding: over a step of length `reach` the
/// difference moves a component by more than 1e-5 of what is negligible there. (A stiff component may look so.)
template <class Scalar, class Vector>
bool may_have_jumped(const Vector& f0, const Vector& f, const Vector& negligible, const Scalar& reach) {
    using std::abs;
    bool jump = false;
    if (reach > Scalar(0))
        for (Eigen::Index i = 0; i < f.size(); ++i)
            jump = jump || reach * abs(f[i] - f0[i]) > negligible[i] / 100000;
    return jump;
}

/// Calls f beside y for a column of a Jacobian, or for several that share no row: move(part) moves their components by that
/// part of their increments, call() writes f. Where f is not finite there, y has left its domain (a positive state that
/// decays is moved towards zero): then to the other side, then by a 1024th either way. Returns the calls.
template <class Scalar, class Vector, class Move, class Call>
int call_beside(const Vector& f, Move&& move, Call&& call) {
    int calls = 0;
    const Scalar small = Scalar(1) / 1024;
    for (const Scalar& part : {Scalar(1), Scalar(-1), small, Scalar(-small)}) {
        move(part);
        call();
        ++calls;
        if (f.allFinite()) break;
    }
    return calls;
}

/// df/dy by forward differences, n evaluations of f. The increment of component j is sqrt(eps) max(|y_j|,
/// negligible_j), in the direction of f_j: relative where y_j is large, never below what the tolerance calls
/// zero; the other way, or smaller, where f is not finite (call_beside). Runs often begin exactly where f jumps (a block at
/// rest with dry friction): in a first step, of length `reach` (0 in later ones), a column that may contain a jump is taken
/// between one increment and two, by one evaluation more.
template <class Scalar, int N>
class finite_difference_jacobian {
  public:
    explicit finite_difference_jacobian(Eigen::Index n) : y_(n), f_(n) {}

    /// Writes J, given f0 = f(t, y), what counts as negligible in every component, and how far a first step reaches;
    /// returns the evaluations.
    template <class Problem, class Vector, class Matrix>
    int operator()(Problem& problem, const Scalar& t, const Vector& y, const Vector& f0,
                   const Vector& negligible, const Scalar& reach, Matrix& J) {
        using std::abs;
        using std::sqrt;
        const Scalar root = sqrt(std::numeric_limits<Scalar>::epsilon());
        const int n = static_cast<int>(y.size());
        int calls = 0;
        y_ = y;
        for (int j = 0; j < n; ++j) {
            const Scalar size = abs(y[j]) > negligible[j] ? abs(y[j]) : negligible[j];
            const Scalar whole =
                root * (f0[j] < Scalar(0) ? Scalar(-size) : size);  // where the solution goes
            Scalar step(0);
            calls += call_beside<Scalar>(
                f_,
                [&](const Scalar& part) {
                    y_[j] = y[j] + part * whole;
                    step = y_[j] - y[j];
                },
                [&] {
                    f_.setZero(n);
                    problem(t, y_, f_);
                });
            const bool jump = may_have_jumped(f0, f_, negligible, reach);
            for (int i = 0; i < n; ++i) J(i, j) = jump ? f_[i] : f0[i];
            if (jump) {
                y_[j] += step;
                problem(t, y_, f_);
                ++calls;
                if (!f_.allFinite()) {
                    f_ = J.col(j);
                    for (int i = 0; i < n; ++i) J(i, j) = f0[i];
                }
            }
            for (int i = 0; i < n; ++i) J(i, j) = (f_[i] - J(i, j)) / step;
            y_[j] = y[j];
        }
        return calls;
    }

  private:
    Eigen::Matrix<Scalar, N, 1> y_, f_;
};

}  // namespace stagecraft
