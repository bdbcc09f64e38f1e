// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <tuple>
#include <type_traits>

#include <stagecraft/integrate.hpp>
#include <stagecraft/jacobian/automatic.hpp>
#include <stagecraft/refuse/problem/checked_capabilities.hpp>
#include <stagecraft/refuse/problem/written_argument.hpp>

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

/// How df/dp is found: by problem.parameter_jacobian(t, y, p, F), or by automatic differentiation.
template <class Problem, class Vector, class Parameters>
struct parameter_derivatives {
    using scalar = typename Vector::Scalar;
    static constexpr int N = Vector::RowsAtCompileTime, M = Parameters::RowsAtCompileTime;
    using number = dual<scalar, M>;
    using state = Eigen::Matrix<number, N, 1>;
    using values = Eigen::Matrix<number, M, 1>;
    template <class Matrix>
    static constexpr bool writes = requires(const Problem& problem, const scalar& t, const Vector& y,
                                            const Parameters& p, Matrix& F) {
        problem.parameter_jacobian(t, y, p, F);
    };
    using dense_matrix = Eigen::Matrix<scalar, N, M>;
    using sparse_matrix = Eigen::SparseMatrix<scalar>;
    static constexpr bool sparse = writes<sparse_matrix> && !writes<dense_matrix>;
    static constexpr bool given = writes<dense_matrix> || sparse;
    /// parameter_adjoint(t, y, p, v, q) writes (df/dp)^T v into q.
    static constexpr bool adjoint_given = requires(const Problem& problem, const scalar& t, const Vector& v,
                                                   const Parameters& p, Parameters& q) {
        problem.parameter_adjoint(t, v, p, v, q);
    };
    using matrix = std::conditional_t<sparse, sparse_matrix, dense_matrix>;
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

/// parameter_jacobian(t, y, p, F) takes F by value, or parameter_adjoint(t, y, p, v, q) takes q.
template <class Problem, class Vector, class P, class Matrix, class S = typename Vector::Scalar>
concept parameter_jacobian_takes_copy = requires(const Problem& f, const S& t, const Vector& y, const P& p) {
    f.parameter_jacobian(t, y, p, std::declval<Matrix>());
}
&&(!requires(const Problem& f, const S& t, const Vector& y, const P& p, passed_by_reference<Matrix>& F) {
    f.parameter_jacobian(t, y, p, F);
} ||
   std::is_same_v<typename last_parameter<decltype(&Problem::parameter_jacobian)>::type, Matrix>);
template <class Problem, class Vector, class P, class S = typename Vector::Scalar>
concept parameter_adjoint_takes_copy = requires(const Problem& f, const S& t, const Vector& y, const P& p) {
    f.parameter_adjoint(t, y, p, y, std::declval<P>());
}
&&(!requires(const Problem& f, const S& t, const Vector& y, const P& p, passed_by_reference<P>& q) {
    f.parameter_adjoint(t, y, p, y, q);
} ||
   std::is_same_v<typename last_parameter<decltype(&Problem::parameter_adjoint)>::type, P>);

/// Refuses a problem(t, y, p, f) of which what it writes is lost.
template <class Problem, class Vector, class Parameters>
struct checked_outputs {
    using matrix = typename parameter_derivatives<Problem, Vector, Parameters>::matrix;
    static_assert(
        writes_into<const Problem, Vector, typename Vector::Scalar, Vector, Parameters>,
        "sensitivities and adjoint_gradient: the problem takes f by value, or const, and what it writes is "
        "lost: write `Vector& f` or `auto& f`");
    static_assert(
        !parameter_jacobian_takes_copy<Problem, Vector, Parameters, matrix>,
        "problem.parameter_jacobian(t, y, p, F) takes F by value, and what it writes is lost: write "
        "`Matrix& F` or `auto& F`");
    static_assert(
        !parameter_adjoint_takes_copy<Problem, Vector, Parameters>,
        "problem.parameter_adjoint(t, y, p, v, q) takes q by value, and what it writes is lost: write "
        "`Vector& q` or `auto& q`");
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

/// The mass matrix depends on p.
template <class Problem, class Parameters>
concept mass_of_parameters = requires(const Problem& problem, const Parameters& p) {
    problem.mass(p).rows();
};
/// The same with mass() where there is mass(p).
template <class Problem, class Parameters>
struct mass_at_parameters : parameters_of<Problem, Parameters> {
    using parameters_of<Problem, Parameters>::parameters_of;
};
template <class Problem, class Parameters>
requires mass_of_parameters<Problem, Parameters>
struct mass_at_parameters<Problem, Parameters> : parameters_of<Problem, Parameters> {
    using parameters_of<Problem, Parameters>::parameters_of;
    auto mass() const { return Problem::mass(this->p); }
};

}  // namespace detail

/// A problem(t, y, p, f) at one p: a problem(t, y, f) with all optional members that do not depend on p, with
/// jacobian(t, y, J) where there is jacobian(t, y, p, J), and with mass() where there is mass(p).
template <class Problem, class Parameters>
struct at_parameters : detail::mass_at_parameters<Problem, Parameters> {
    using original = Problem;
    using parameters = Parameters;
    using detail::mass_at_parameters<Problem, Parameters>::mass_at_parameters;
    using detail::parameters_of<Problem, Parameters>::p;
    static constexpr bool mass_depends = detail::mass_of_parameters<Problem, Parameters>;

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

    /// f := f(t, y, q) - M(q) slope in the numbers of y and q, which carry derivatives; the second part only where M
    /// depends on q. That is what the stages of a derivative of the solution see.
    template <class By, class Scalar, class Y, class Q, class Vector, class F>
    void residual(const Scalar& t, const Y& y, const Q& q, [[maybe_unused]] const Vector& slope, F& f) const {
        using number = typename F::Scalar;
        const auto& problem = static_cast<const Problem&>(*this);
        if constexpr (By::dual_time)
            problem(number(t), y, q, f);
        else
            problem(t, y, q, f);
        if constexpr (mass_depends)
            f -= Eigen::Matrix<number, Y::RowsAtCompileTime, 1>(problem.mass(q) *
                                                                detail::promoted<number>(slope));
    }
};

}  // namespace stagecraft
