// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <stagecraft/problem/capabilities.hpp>
#include <utility>
#include <vector>

namespace thesis {

/// A problem of any fixed-size type behind one type, so that one instantiation of the integrator serves them
/// all: compiling the experiments is what costs here, not running them.
struct any_problem {
    std::function<void(double, const Eigen::VectorXd&, Eigen::VectorXd&)> f;
    std::function<void(double, const Eigen::VectorXd&, Eigen::MatrixXd&)> df;
    Eigen::MatrixXd M;
    std::vector<int> flags;

    void operator()(double t, const Eigen::VectorXd& y, Eigen::VectorXd& out) const { f(t, y, out); }
    void jacobian(double t, const Eigen::VectorXd& y, Eigen::MatrixXd& J) const { df(t, y, J); }
    const Eigen::MatrixXd& mass() const { return M; }
    const std::vector<int>& index() const { return flags; }
};

/// Wraps a problem with state size Problem::size; Jacobian, mass matrix and index flags included.
template <class Problem>
any_problem erased(Problem problem) {
    constexpr int n = Problem::size;
    using vector = Eigen::Matrix<double, n, 1>;
    using matrix = Eigen::Matrix<double, n, n>;
    const auto shared = std::make_shared<Problem>(std::move(problem));
    any_problem result;
    if constexpr (stagecraft::has_mass<Problem>)
        result.M = shared->mass();
    else
        result.M = Eigen::MatrixXd::Identity(n, n);
    result.flags.assign(n, 1);
    if constexpr (stagecraft::has_index<Problem>)
        for (int i = 0; i < n; ++i) result.flags[i] = shared->index()[i];
    result.f = [shared](double t, const Eigen::VectorXd& y, Eigen::VectorXd& out) {
        const vector fixed = y;
        vector value;
        (*shared)(t, fixed, value);
        out = value;
    };
    result.df = [shared](double t, const Eigen::VectorXd& y, Eigen::MatrixXd& J) {
        const vector fixed = y;
        matrix value;
        shared->jacobian(t, fixed, value);
        J = value;
    };
    return result;
}

}  // namespace thesis
