// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <ostream>
#include <type_traits>
#include <vector>

#include <stagecraft/mechanics/model.hpp>
#include <stagecraft/owned_value.hpp>

namespace stagecraft {

namespace detail {

template <class Problem, class Vector, class Scalar>
auto gradient_in_state(const Problem& problem, const Vector& y, const Scalar& t) {
    if constexpr (requires { problem.constraint_gradient(y, t); }) {
        return problem.constraint_gradient(y, t);
    } else {
        using Model = std::remove_cvref_t<decltype(problem.model())>;
        const coordinate_vector<Scalar, Model> q = y.head(Model::coordinates);
        return stagecraft::constraint_gradient<Scalar>(problem.model(), q, t);
    }
}

}  // namespace detail

/// The force of every constraint in a state y of any formulation of a model: column k is lambda_k times row k of
/// G, n x m, sparse where the model's G is. The equations of motion are M a = F - the sum of the columns.
template <class Problem, class Vector>
auto constraint_forces(const Problem& problem, const Vector& y, const typename Vector::Scalar& t = 0) {
    using scalar = typename Vector::Scalar;
    const auto G = detail::gradient_in_state(problem, y, t);
    const auto lambda = problem.multiplier(y, t);
    if constexpr (requires { G(0, 0); }) {
        constexpr int n = decltype(G)::ColsAtCompileTime, m = decltype(G)::RowsAtCompileTime;
        return Eigen::Matrix<scalar, n, m>(G.transpose() * lambda.asDiagonal());
    } else {
        return Eigen::SparseMatrix<scalar>(G.transpose() * lambda.asDiagonal());
    }
}

/// Writes the multipliers and the forces of the constraints at the given times as comma-separated values, one line
/// per time: t, lambda_0 ... lambda_(m-1), then force_k_i, what constraint k has in equation i (M a = F - G^T
/// lambda). Where G is sparse, force_i, the sum over the constraints. `y` is anything that gives the state at a
/// time, such as a `solution` (observe/solution.hpp).
template <class Problem, class Solution, class Scalar>
void write_constraint_forces(std::ostream& out, const Problem& problem, const Solution& y,
                             const std::vector<Scalar>& times) {
    bool first = true;
    for (const Scalar& t : times) {
        static_assert(detail::owns_numbers<decltype(y(t))>,
                      "write_constraint_forces: y(t) returns an expression of Eigen's, whose operands may be "
                      "gone: write its type or .eval()");
        const auto state = y(t);
        const auto lambda = problem.multiplier(state, t);
        const auto forces = constraint_forces(problem, state, t);
        constexpr bool dense = requires { forces(0, 0); };
        if (first) {
            out << "t";
            for (int k = 0; k < lambda.size(); ++k) out << ",lambda_" << k;
            for (int k = 0; k < (dense ? lambda.size() : 1); ++k)
                for (int i = 0; i < forces.rows(); ++i) {
                    out << ",force_";
                    if (dense) out << k << '_';
                    out << i;
                }
            out << '\n';
        }
        first = false;
        out << t;
        for (int k = 0; k < lambda.size(); ++k) out << ',' << lambda[k];
        if constexpr (dense) {
            for (int k = 0; k < lambda.size(); ++k)
                for (int i = 0; i < forces.rows(); ++i) out << ',' << forces(i, k);
        } else {
            Eigen::Matrix<Scalar, Eigen::Dynamic, 1> sum =
                forces * Eigen::Matrix<Scalar, Eigen::Dynamic, 1>::Ones(forces.cols());
            for (int i = 0; i < sum.size(); ++i) out << ',' << sum[i];
        }
        out << '\n';
    }
}

}  // namespace stagecraft
