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
template <class Scalar>
struct problem_of {
    using vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    std::function<void(Scalar, const vector&, vector&)> f;
    std::function<void(Scalar, const vector&, matrix&)> df;
    matrix M;
    std::vector<int> flags;

    void operator()(Scalar t, const vector& y, vector& out) const { f(t, y, out); }
    void jacobian(Scalar t, const vector& y, matrix& J) const { df(t, y, J); }
    const matrix& mass() const { return M; }
    const std::vector<int>& index() const { return flags; }
};
using any_problem = problem_of<double>;

/// Wraps a problem with state size Problem::size; Jacobian, mass matrix and index flags included.
template <class Scalar = double, class Problem>
problem_of<Scalar> erased(Problem problem) {
    constexpr int n = Problem::size;
    using fixed_vector = Eigen::Matrix<Scalar, n, 1>;
    using fixed_matrix = Eigen::Matrix<Scalar, n, n>;
    using vector = typename problem_of<Scalar>::vector;
    using matrix = typename problem_of<Scalar>::matrix;
    const auto shared = std::make_shared<Problem>(std::move(problem));
    problem_of<Scalar> result;
    if constexpr (stagecraft::has_mass<Problem>)
        result.M = shared->mass();
    else
        result.M = matrix::Identity(n, n);
    result.flags.assign(n, 1);
    if constexpr (stagecraft::has_index<Problem>)
        for (int i = 0; i < n; ++i) result.flags[i] = shared->index()[i];
    result.f = [shared](Scalar t, const vector& y, vector& out) {
        const fixed_vector fixed = y;
        fixed_vector value;
        (*shared)(t, fixed, value);
        out = value;
    };
    result.df = [shared](Scalar t, const vector& y, matrix& J) {
        const fixed_vector fixed = y;
        fixed_matrix value;
        shared->jacobian(t, fixed, value);
        J = value;
    };
    return result;
}

}  // namespace thesis
