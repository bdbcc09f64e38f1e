// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/jacobian/dual_functions.hpp>
#include <stagecraft/jacobian/unconverted.hpp>

namespace stagecraft {

/// Number of directions carried at once: all of them for a small fixed size, else chunks of eight, so that no
/// dual number allocates.
template <int N>
inline constexpr int dual_width = (N > 0 && N <= 16) ? N : 8;

/// The dual numbers in which a generic right-hand side is differentiated.
template <class Scalar, int N>
using dual = dual_number<Scalar, dual_width<N>>;

/// N of them: y or f while f is differentiated. N may be Eigen::Dynamic.
template <class Scalar, int N>
using dual_vector = Eigen::Matrix<dual<Scalar, N>, N, 1>;

/// True if f(t, y, f) accepts dual vectors, with t dual as well or left as it is. Asking this compiles the
/// body of a lambda with a generic y and a deduced return type: if the body does not compile with dual_number, give
/// y a concrete type or bring a Jacobian.
template <class Problem, class Scalar, int N>
concept differentiable_with_dual_time = detail::callable_unconverted < Problem,
        const dual<Scalar, N>
&, const dual_vector<Scalar, N>&, dual_vector<Scalar, N>& > ;
/// The same with t as a plain number.
template <class Problem, class Scalar, int N>
concept differentiable_with_plain_time = detail::callable_unconverted < Problem,
        const Scalar&, const dual_vector<Scalar, N>
&, dual_vector<Scalar, N>& > ;
/// Either of them: no Jacobian has to be brought, and none is approximated by differences.
template <class Problem, class Scalar, int N>
concept automatically_differentiable =
    differentiable_with_dual_time<Problem, Scalar, N> || differentiable_with_plain_time<Problem, Scalar, N>;

/// df/dy by forward-mode automatic differentiation (dual_number), exact to rounding: ceil(n /
/// width) evaluations of f in dual numbers.
template <class Scalar, int N>
class automatic_jacobian {
  public:
    explicit automatic_jacobian(Eigen::Index n) : y_(n), f_(n) {}

    /// Writes J; returns the number of (dual) evaluations.
    template <class Problem, class Vector, class Matrix>
    int operator()(Problem& problem, const Scalar& t, const Vector& y, const Vector&, Matrix& J) {
        constexpr int width = dual_width<N>;
        const int n = static_cast<int>(y.size());
        int evaluations = 0;
        for (int first = 0; first < n; first += width, ++evaluations) {
            for (int i = 0; i < n; ++i) {
                y_[i].value() = y[i];
                y_[i].derivatives().setZero();
                if (i >= first && i < first + width) y_[i].derivatives()[i - first] = Scalar(1);
            }
            if constexpr (differentiable_with_dual_time<Problem, Scalar, N>) {
                dual<Scalar, N> time(t);
                time.derivatives().setZero();
                problem(time, y_, f_);
            } else {
                problem(t, y_, f_);
            }
            for (int j = first; j < n && j < first + width; ++j)
                for (int i = 0; i < n; ++i) J(i, j) = f_[i].derivatives()[j - first];
        }
        return evaluations;
    }

  private:
    dual_vector<Scalar, N> y_, f_;
};

}  // namespace stagecraft
