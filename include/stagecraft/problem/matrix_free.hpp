// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <stagecraft/jacobian/dual_functions.hpp>
#include <stagecraft/jacobian/finite_difference.hpp>
#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/linear/krylov_blocks.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>

namespace stagecraft {

namespace detail {

using one_dual = dual_number<double, 1>;
using dual_state = Eigen::Matrix<one_dual, Eigen::Dynamic, 1>;

template <class Problem>
concept dual_in_time_and_state =
    callable_unconverted<const Problem, const one_dual&, const dual_state&, dual_state&>;
template <class Problem>
concept dual_in_state = callable_unconverted<const Problem, const double&, const dual_state&, dual_state&>;

/// J = df/dy at a state, by its products alone, each of which evaluates f once.
template <class Problem>
class directional_derivative {
  public:
    directional_derivative(const Problem& problem, Eigen::Index n)
        : problem_(&problem),
          y_(n),
          f_(n),
          moved_(n),
          f_moved_(n),
          dual_y_(dual ? n : 0),
          dual_f_(dual ? n : 0) {}
    Eigen::Index rows() const { return y_.size(); }
    Eigen::Index cols() const { return y_.size(); }
    void set(double t, const Eigen::VectorXd& y) {
        t_ = t;
        y_ = y;
        if constexpr (!dual) {
            (*problem_)(t_, y_, f_);
            ++calls_;
        }
    }
    /// r := r + factor J x.
    void add_times(double factor, const double* x, double* r) const {
        const Eigen::Map<const Eigen::VectorXd> v(x, rows());
        Eigen::Map<Eigen::VectorXd> result(r, rows());
        if constexpr (dual) {
            ++calls_;
            for (Eigen::Index i = 0; i < rows(); ++i) {
                dual_y_[i].value() = y_[i];
                dual_y_[i].derivatives()[0] = v[i];
            }
            if constexpr (dual_in_time_and_state<Problem>)
                (*problem_)(one_dual(t_), dual_y_, dual_f_);
            else
                (*problem_)(t_, dual_y_, dual_f_);
            for (Eigen::Index i = 0; i < rows(); ++i) result[i] += factor * dual_f_[i].derivatives()[0];
        } else {
            const double length = v.norm();
            if (length == 0) return;
            const double whole = std::sqrt(std::numeric_limits<double>::epsilon()) * (1 + y_.norm()) / length;
            double step = whole;
            calls_ += call_beside<double>(
                f_moved_,
                [&](double part) {
                    step = part * whole;
                    moved_ = y_ + step * v;
                },
                [&] { (*problem_)(t_, moved_, f_moved_); });
            result += factor / step * (f_moved_ - f_);
        }
    }
    void precondition(double shift, double* x) const { problem_->precondition(shift, x); }
    /// Calls of f since this was asked last.
    long take_calls() const { return std::exchange(calls_, 0); }

  private:
    static constexpr bool dual = dual_in_time_and_state<Problem> || dual_in_state<Problem>;
    const Problem* problem_;
    double t_ = 0;
    mutable long calls_ = 0;
    Eigen::VectorXd y_, f_;
    mutable Eigen::VectorXd moved_, f_moved_;
    mutable dual_state dual_y_, dual_f_;
};

template <class Problem>
class matrix_free_problem : public Problem {
  public:
    using linear_solver = krylov_blocks;
    matrix_free_problem(Problem p, Eigen::Index components)
        : Problem(std::move(p)), components_(components) {}
    using Problem::operator();
    auto matrix() const { return directional_derivative<Problem>(*this, components_); }
    void jacobian(double t, const Eigen::VectorXd& y, directional_derivative<Problem>& J) const {
        J.set(t, y);
    }

  private:
    Eigen::Index components_;
};

}  // namespace detail

/// A problem with n components that is solved by krylov_blocks without any matrix. Beside f(t, y) it has
///
///     void precondition(double shift, double* x) const;   // x := about (shift M - J)^-1 x, n contiguous numbers
///
/// and J v is a derivative in the direction of v: in dual numbers, exact to rounding, where f takes states of any scalar
/// type, else the difference quotient with sqrt(epsilon) (1 + |y|)/|v|, norms being Euclidean: scale y such that this
/// moves no component by more than it may. Each product costs one call of f (about two in dual numbers), which
/// result.report counts in f_jacobian: an iteration takes one for a real system and two for a pair. A preconditioner too
/// weak for steps of useful length makes steps short, or ends the run with status::linear_solver_failed, as one that
/// gives NaN or zeros does. f and precondition must be const. Memory: 5 n numbers beside those of krylov_blocks. std::invalid_argument for a negative n.
///
/// A problem with precondition is not solved in this way unasked, as it could be: a program that uses no preconditioner would
/// include those solvers, and every entrance (integrate, steps, checkpoints) would make copies of the problem. Given without
/// matrix_free it does not compile; nor does a problem with a jacobian here, which would not be used.
template <class Problem>
auto matrix_free(Problem problem, Eigen::Index n) {
    static_assert(
        requires(const Problem& p, double* x) { p.precondition(1.0, x); },
        "matrix_free: the problem needs a member precondition(shift, x) const");
    static_assert(!detail::has_member_named<Problem, detail::jacobian_member>,
                  "matrix_free: the problem has a member jacobian, which would not be used: leave it out, or "
                  "use krylov_blocks with sparsity() and that Jacobian");
    if (n < 0) throw std::invalid_argument("matrix_free: n must not be negative");
    return detail::matrix_free_problem<Problem>(std::move(problem), n);
}

}  // namespace stagecraft
