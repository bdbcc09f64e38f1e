// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <string>

/// What one run of one solver on one problem gives.
struct outcome {
    Eigen::VectorXd y;
    bool ok = false;
    long steps = 0, f = 0, jacobians = 0, factorisations = 0;
    long rejected = 0;   ///< of the steps
    std::string status;  ///< why the run ended
};

template <class Problem>
using state_of = Eigen::Matrix<double, Problem::size, 1>;
template <class Problem>
using jacobian_of = Eigen::Matrix<double, Problem::size, Problem::size>;

/// max |e_i| / (|ref_i| + atol/rtol).
inline double scaled_error(const Eigen::VectorXd& y, const Eigen::VectorXd& reference,
                           double atol_over_rtol) {
    return ((y - reference).array().abs() / (reference.array().abs() + atol_over_rtol)).maxCoeff();
}
