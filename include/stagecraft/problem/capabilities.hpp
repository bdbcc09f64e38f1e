// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <type_traits>
#include <utility>

namespace stagecraft {

/// The one thing a problem must bring: `problem(t, y, f)` writes f(t, y) into f, which arrives with the size
/// of y. M y' = f(t, y), M the identity unless the problem has a member `mass()`.
template <class Problem, class Vector>
concept right_hand_side = Eigen::MatrixBase<Vector>::ColsAtCompileTime == 1 &&
                          requires(Problem& p, const typename Vector::Scalar& t, const Vector& y, Vector& f) {
    p(t, y, f);
};

/// Optional: `problem.jacobian(t, y, J)` writes df/dy into J.
template <class Problem, class Vector, class Matrix>
concept has_jacobian = requires(Problem& p, const typename Vector::Scalar& t, const Vector& y, Matrix& J) {
    p.jacobian(t, y, J);
};

/// Optional: `problem.mass()` returns the constant matrix M (dense or Eigen::DiagonalMatrix), singular
/// allowed.
template <class Problem>
concept has_mass = requires(Problem& p) {
    p.mass();
};

/// Optional: `problem.index()` returns something indexable with size(): the differentiation index 1, 2 or 3
/// of each component (HLR89; 0 and 1 mean the same). Newton and error norms weigh a component by |h|^(index -
/// 1).
template <class Problem>
concept has_index = requires(Problem& p) {
    { p.index()[0] } -> std::convertible_to<int>;
    p.index().size();
};

/// Optional: `problem.constant_jacobian()` returns true when df/dy depends neither on t nor on y:
/// then J is evaluated once in a run.
template <class Problem>
concept has_constant_jacobian = requires(Problem& p) {
    { p.constant_jacobian() } -> std::convertible_to<bool>;
};

}  // namespace stagecraft
