// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>

// Problems with smooth solutions and the Jacobian in closed form, which costs a test less to compile than a derived one.
namespace smooth {

// Stiff with solution cos t (Prothero and Robinson 1974): y' = lambda (y - cos t) - share sin t, share = 1. Any other share
// leaves a solution that is near cos t.
struct prothero_robinson {
    double lambda, share = 1;
    void operator()(double t, const Eigen::Matrix<double, 1, 1>& y, Eigen::Matrix<double, 1, 1>& f) const {
        f[0] = lambda * (y[0] - std::cos(t)) - share * std::sin(t);
    }
    void jacobian(double, const Eigen::Matrix<double, 1, 1>&, Eigen::Matrix<double, 1, 1>& J) const {
        J(0, 0) = lambda;
    }
};

// Index 1: y = exp(sin t), z = y^2 from a constraint solved by no formula.
struct index_one {
    void operator()(double t, const Eigen::Vector2d& y, Eigen::Vector2d& f) const {
        const double square = y[0] * y[0];
        f[0] = y[1] / y[0] * std::cos(t);
        f[1] = y[1] * y[1] * y[1] + y[1] - square * square * square - square;
    }
    void jacobian(double t, const Eigen::Vector2d& y, Eigen::Matrix2d& J) const {
        J << -y[1] / (y[0] * y[0]) * std::cos(t), std::cos(t) / y[0], -6 * std::pow(y[0], 5) - 2 * y[0],
            3 * y[1] * y[1] + 1;
    }
    Eigen::DiagonalMatrix<double, 2> mass() const { return Eigen::DiagonalMatrix<double, 2>(1, 0); }
};

}  // namespace smooth
