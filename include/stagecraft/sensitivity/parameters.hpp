// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <tuple>
#include <type_traits>

#include <stagecraft/integrate.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/problem/checked_capabilities.hpp>

namespace stagecraft {

namespace detail {

/// A vector in the scalar S, its derivatives zero where S has any.
template <class S, class Vector>
Eigen::Matrix<S, Vector::RowsAtCompileTime, 1> promoted(const Vector& x) {
    Eigen::Matrix<S, Vector::RowsAtCompileTime, 1> result(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) result[i] = S(x[i]);
    return result;
}

template <class Problem, class T, class Y, class P, class F>
concept callable_with_parameters = callable_unconverted<const Problem, const T&, const Y&, const P&, F&>;

/// A transformed_tableau or a set of such.
template <class Method>
concept transformed_method = requires(const Method& m) {
    std::get<0>(as_tuple(m)).A_inverse;
};

/// What sensitivities() and adjoint_gradient() may be called with.
template <class Method, class Problem, class Vector, class Parameters>
concept run_with_parameters = transformed_method<Method> &&
    writes_last<const Problem, Vector, typename Vector::Scalar, Vector, Parameters>;

/// How df/dp is found: by problem.parameter_jacobian(t, y, p, F), or in dual numbers.
template <class Problem, class Vector, class Parameters>
struct parameter_derivatives {
    using scalar = typename Vector::Scalar;
    static constexpr int N = Vector::RowsAtCompileTime, M = Parameters::RowsAtCompileTime;
    using number = dual<scalar, M>;
    using state = Eigen::Matrix<number, N, 1>;
    using values = Eigen::Matrix<number, M, 1>;
    static constexpr bool given = requires(const Problem& problem, const scalar& t, const Vector& y,
                                           const Parameters& p, Eigen::Matrix<scalar, N, M>& F) {
        problem.parameter_jacobian(t, y, p, F);
    };
    static constexpr bool dual_time = callable_with_parameters<Problem, number, state, values, state>;
    static constexpr bool automatic = [] {
        if constexpr (dual_time)
            return true;
        else
            return callable_with_parameters<Problem, scalar, state, values, state>;
    }();
    /// What is known before a generic problem is compiled for them: it takes their arguments as they are.
    static constexpr bool exist = [] {
        if constexpr (given)
            return true;
        else if constexpr (std::is_class_v<Problem> && !std::is_final_v<Problem>)
            return !converts_duals<const Problem, const number&, const state&, const values&, state&>() ||
                   !converts_duals<const Problem, const scalar&, const state&, const values&, state&>();
        else
            return automatic;
    }();
};

/// A Problem with its parameters, and with jacobian(t, y, J) where it has jacobian(t, y, p, J).
template <class Problem, class Parameters>
struct parameters_of : Problem {
    Parameters p;
    parameters_of(const Problem& problem, const Parameters& values) : Problem(problem), p(values) {}
};
template <class Problem, class Parameters>
requires has_member_named<Problem, jacobian_member>
struct parameters_of<Problem, Parameters> : Problem {
    Parameters p;
    parameters_of(const Problem& problem, const Parameters& values) : Problem(problem), p(values) {}
    template <class T, class Y, class J>
    requires requires(const Problem& problem, const T& t, const Y& y, const Parameters& values, J& out) {
        problem.jacobian(t, y, values, out);
    }
    void jacobian(const T& t, const Y& y, J& out) const { Problem::jacobian(t, y, p, out); }
};

}  // namespace detail

/// A problem(t, y, p, f) at one p: a problem(t, y, f) with all optional members that do not depend on p, and
/// with jacobian(t, y, J) where there is jacobian(t, y, p, J).
template <class Problem, class Parameters>
struct at_parameters : detail::parameters_of<Problem, Parameters> {
    using parameters = Parameters;
    using detail::parameters_of<Problem, Parameters>::parameters_of;
    using detail::parameters_of<Problem, Parameters>::p;

    template <class T, class Y, class F>
    requires detail::callable_with_parameters<
        Problem, T, Y, Eigen::Matrix<typename F::Scalar, Parameters::RowsAtCompileTime, 1>, F>
    void operator()(const T& t, const Y& y, F& f) const {
        const auto& problem = static_cast<const Problem&>(*this);
        if constexpr (std::is_same_v<typename F::Scalar, typename Parameters::Scalar>) {
            problem(t, y, p, f);
        } else {
            const auto q = detail::promoted<typename F::Scalar>(p);
            problem(t, y, q, f);
        }
    }

    /// F := df/dp, n x m: by problem.parameter_jacobian(t, y, p, F) where that exists (F is zero at the first
    /// call), else by automatic differentiation.
    template <class Scalar, class Vector, class Matrix>
    void differentiate(const Scalar& t, const Vector& y, Matrix& F) const {
        using by = detail::parameter_derivatives<Problem, Vector, Parameters>;
        if constexpr (by::given) {
            static_cast<const Problem&>(*this).parameter_jacobian(t, y, p, F);
        } else {
            static_assert(by::automatic || !by::exist,
                          "sensitivities: problem(t, y, p, f) must be generic in its scalar, t included");
            if constexpr (by::automatic) differentiate_automatically<by>(t, y, F);
        }
    }

  private:
    template <class by, class Scalar, class Vector, class Matrix>
    void differentiate_automatically(const Scalar& t, const Vector& y, Matrix& F) const {
        const auto& problem = static_cast<const Problem&>(*this);
        using number = typename by::number;
        constexpr int width = dual_width<by::M>;
        [[maybe_unused]] const number time(t);
        const typename by::state at = detail::promoted<number>(y);
        typename by::values q = detail::promoted<number>(p);
        typename by::state f(y.size());
        for (Eigen::Index first = 0; first < p.size(); first += width) {
            for (Eigen::Index k = first; k < p.size() && k < first + width; ++k)
                q[k].derivatives()[k - first] = Scalar(1);
            if constexpr (by::dual_time)
                problem(time, at, q, f);
            else
                problem(t, at, q, f);
            for (Eigen::Index k = first; k < p.size() && k < first + width; ++k) {
                for (Eigen::Index i = 0; i < y.size(); ++i) F(i, k) = f[i].derivatives()[k - first];
                q[k].derivatives().setZero();
            }
        }
    }
};

}  // namespace stagecraft
