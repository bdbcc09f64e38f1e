// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/second_order_lu.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/problem/capabilities.hpp>

namespace stagecraft::detail {

/// The matrix that holds the Jacobian of a problem: its own, banded, sparse, or dense. A dense one has no storage
/// before system::take_jacobian().
template <class Problem, class Vector>
auto make_jacobian(Problem& problem, int n) {
    using scalar = typename Vector::Scalar;
    if constexpr (has_matrix<Problem>) {
        static_assert(owns_numbers<decltype(problem.matrix())>,
                      "problem.matrix() returns an expression of Eigen's, whose operands may be gone: write "
                      "its type, `Eigen::MatrixXd matrix() const`, say");
        auto J = problem.matrix();
        if (J.rows() != n || J.cols() != n)
            throw std::invalid_argument("integrate: problem.matrix() must be n x n with n the size of y0");
        return J;
    } else if constexpr (has_bandwidth<Problem>) {
        return banded_matrix<scalar>(n, problem.bandwidth());
    } else if constexpr (has_sparsity<Problem>) {
        auto J = problem.sparsity();
        if (J.rows() != n || J.cols() != n)
            throw std::invalid_argument("integrate: problem.sparsity() must be n x n with n the size of y0");
        J.makeCompressed();
        return J;
    } else {
        return Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime>();
    }
}

/// What solves linear systems with such a Jacobian: the problem's own linear_solver, else what its structure asks for.
template <class Problem, class Matrix>
struct blocks_for : default_blocks<Matrix> {};
template <class Problem, class Matrix>
requires(has_second_order_components<Problem> && !has_linear_solver<Problem> && !has_bandwidth<Problem> &&
         !has_sparsity<Problem>) struct blocks_for<Problem, Matrix> {
    using type = second_order_blocks<typename Matrix::Scalar, Matrix::RowsAtCompileTime,
                                     Problem::second_order_components>;
};
template <class Problem, class Matrix>
requires has_linear_solver<Problem>
struct blocks_for<Problem, Matrix> {
    using type = typename Problem::linear_solver;
};

}  // namespace stagecraft::detail
