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

/// df/dy by forward differences, n evaluations of f. The increment of component j is sqrt(eps) max(|y_j|,
/// negligible_j), in the direction of f_j: relative where y_j is large, never below what the tolerance calls
/// zero. Runs often begin exactly where f jumps (a block at rest with dry friction): in a first step, of length `reach` (0
/// in later ones), a column that may contain a jump is taken between one increment and two, by one evaluation more.
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
        int calls = n;
        y_ = y;
        for (int j = 0; j < n; ++j) {
            const Scalar size = abs(y[j]) > negligible[j] ? abs(y[j]) : negligible[j];
            y_[j] =
                y[j] + root * (f0[j] < Scalar(0) ? Scalar(-size) : size);  // towards where the solution goes
            const Scalar step = y_[j] - y[j];
            f_.setZero(n);
            problem(t, y_, f_);
            const bool jump = may_have_jumped(f0, f_, negligible, reach);
            for (int i = 0; i < n; ++i) J(i, j) = jump ? f_[i] : f0[i];
            if (jump) {
                y_[j] += step;
                problem(t, y_, f_);
                ++calls;
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
