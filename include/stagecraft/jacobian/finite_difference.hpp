// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace stagecraft {

/// df/dy by forward differences, n evaluations of f. The increment of component j is sqrt(eps) max(|y_j|,
/// negligible_j), in the direction of f_j: relative where y_j is large, never below what the tolerance calls
/// zero.
template <class Scalar, int N>
class finite_difference_jacobian {
  public:
    explicit finite_difference_jacobian(Eigen::Index n) : y_(n), f_(n) {}

    /// Writes J, given f0 = f(t, y) and what counts as negligible in every component; returns the
    /// evaluations.
    template <class Problem, class Vector, class Matrix>
    int operator()(Problem& problem, const Scalar& t, const Vector& y, const Vector& f0,
                   const Vector& negligible, Matrix& J) {
        using std::abs;
        using std::sqrt;
        const Scalar root = sqrt(std::numeric_limits<Scalar>::epsilon());
        const int n = static_cast<int>(y.size());
        y_ = y;
        for (int j = 0; j < n; ++j) {
            const Scalar size = abs(y[j]) > negligible[j] ? abs(y[j]) : negligible[j];
            y_[j] =
                y[j] + root * (f0[j] < Scalar(0) ? Scalar(-size) : size);  // towards where the solution goes
            const Scalar step = y_[j] - y[j];
            f_.setZero(n);
            problem(t, y_, f_);
            for (int i = 0; i < n; ++i) J(i, j) = (f_[i] - f0[i]) / step;
            y_[j] = y[j];
        }
        return n;
    }

  private:
    Eigen::Matrix<Scalar, N, 1> y_, f_;
};

}  // namespace stagecraft
