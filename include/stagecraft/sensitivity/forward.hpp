// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <exception>
#include <type_traits>

#include <stagecraft/integrate.hpp>
#include <stagecraft/sensitivity/linear_stages.hpp>
#include <stagecraft/sensitivity/parameters.hpp>
#include <stagecraft/sensitivity/stage_derivatives.hpp>

namespace stagecraft {

/// The result of a run with dy/dp at its end, n x m.
template <class Vector, class Matrix>
struct sensitivity_result : result<Vector> {
    Matrix S;
};

namespace detail {

/// dy/dp along a run: after each of its steps the same step of M S' = f_y S + f_p.
template <class Problem, class Vector>
class forward_sensitivities {
    using scalar = typename Vector::Scalar;

  public:
    using matrix = typename stage_derivatives<Problem, Vector>::parameter_matrix;

    forward_sensitivities(const Problem& problem, const Vector& y0, const options<scalar>& o,
                          const matrix& S0)
        : at_(problem, y0, o), S_(S0), column_(y0), weights_(y0) {}

    const matrix& S() const { return S_; }

    /// Takes the step that `run` has just made; false if its linear equations could not be solved.
    template <class Run>
    bool step(Run& run) {
        return run.visit_last([&](auto& method) {
            auto& stages = method.stages();
            const auto& output = run.output();
            at_.evaluate(stages.method(), output);
            at_.relative_weights(output.y0(), weights_);
            const auto d = update_weights(stages.method());
            Z_.resize(S_.rows(), stages.stages());
            for (Eigen::Index k = 0; k < S_.cols(); ++k) {
                column_ = S_.col(k);
                const auto add = [&](int i, const Vector& v, Vector& f) {
                    f = at_.F(i).col(k);
                    add_product(at_.J(i), v, f);
                };
                if (!solve_linear_stages(stages, at_.mass(), add, column_, output.step(), weights_,
                                         at_.tolerance(), Z_))
                    return false;
                for (int j = 0; j < stages.stages(); ++j) S_.col(k) += d[j] * Z_.col(j);
            }
            return true;
        });
    }

  private:
    stage_derivatives<Problem, Vector> at_;
    matrix S_;
    Vector column_, weights_;
    Eigen::Matrix<scalar, Vector::RowsAtCompileTime, Eigen::Dynamic> Z_;
};

struct call_of_sensitivities {
    template <class Method>
    static constexpr bool say() {
        static_assert(transformed_method<Method> || never<Method>,
                      "sensitivities: the first argument must be a transformed_tableau or a variable_order "
                      "set, radau_iia<3>() with its parentheses, say");
        static_assert(
            !transformed_method<Method> || never<Method>,
            "sensitivities(method, problem, y0, p, t0, t1, options, S0, observer): the problem must be "
            "callable as problem(t, y, p, f), y0 and p be column vectors of Eigen's (one parameter too: "
            "Eigen::Matrix<double, 1, 1>(2.0)), and options have the names that they have for integrate()");
        return true;
    }
};

}  // namespace detail

/// Integrates M y' = f(t, y, p) together with its sensitivities S = dy/dp, M S' = f_y S + f_p, S(t0) = S0.
///
/// Staggered and direct (Caracotsios-Stewart 1985): after every accepted step of y the same step is made with
/// S, whose stage equations are linear; they are solved to rounding with the factors that the step of y has used (within
/// rtol where these or rounding errors of a large h f_y allow no more). So S is the derivative of the numerical solution
/// with respect to p, the step sizes held fixed, and converges with the order of y in all components, algebraic ones
/// included. The step control looks at y alone.
///
/// f must have derivatives along the solution. Where f jumps at a place that depends on y or p, S jumps as well, by an
/// amount that no derivative of f shows: S is wrong from there on, in a run that ends with success. Such a run is stopped
/// at the event, S is corrected there (Galan-Feehery-Barton 1999), and a new one begins.
///
/// problem  problem(t, y, p, f) writes f(t, y, p); y, p, f are Eigen's vectors. Optional: jacobian(t, y, p, J) (else
///          as in integrate()), parameter_jacobian(t, y, p, F) with F n x m (else automatic differentiation,
///          for which the callable must be generic), and the members that do not depend on p: mass(),
///          index(), bandwidth(), sparsity(), linear_solver.
/// method   A transformed_tableau other than Radau IA, or a set of such (radau_iia_variable()).
/// S0       dy0/dp, zero if it is left out. Components that are algebraic need not be consistent.
/// observer Called as observer(t, y, S) after every step, if given; where it returns false the run ends.
///
/// Costs s Jacobians and, for each parameter, some ten solves with the factors there are, in every step. A step whose linear
/// equations the factors do not solve ends the run with status::newton_failed. std::invalid_argument as integrate().
template <class Method, class Problem, class DerivedY, class DerivedP, class Observer = no_observer>
requires detail::run_with_parameters<Method, Problem, typename DerivedY::PlainObject,
                                     typename DerivedP::PlainObject>
auto sensitivities(
    const Method& method, const Problem& problem, const Eigen::MatrixBase<DerivedY>& y0,
    const Eigen::MatrixBase<DerivedP>& p, std::type_identity_t<typename DerivedY::Scalar> t0,
    std::type_identity_t<typename DerivedY::Scalar> t1, const options<typename DerivedY::Scalar>& o = {},
    const std::type_identity_t<Eigen::Matrix<typename DerivedY::Scalar, DerivedY::RowsAtCompileTime,
                                             DerivedP::RowsAtCompileTime>>* S0 = nullptr,
    Observer&& observer = {}) {
    using vector = typename DerivedY::PlainObject;
    using parameters = typename DerivedP::PlainObject;
    constexpr bool differentiable = detail::parameter_derivatives<Problem, vector, parameters>::exist;
    static_assert(
        differentiable,
        "sensitivities: problem(t, y, p, f) must be generic in its scalar (const auto& t, const auto& y, "
        "const auto& p, auto& f), or the problem have a member parameter_jacobian(t, y, p, F)");
    using bound = at_parameters<Problem, parameters>;
    using forward = detail::forward_sensitivities<bound, vector>;
    using matrix = typename forward::matrix;
    const bound at_p(problem, p);
    const vector start = y0;
    if (S0 && (S0->rows() != y0.size() || S0->cols() != p.size()))
        throw std::invalid_argument(
            "sensitivities: S0 must have a row per component and a column per parameter");
    integrator<Method, const bound, vector> run(method, at_p, start, t0, t1, o);
    forward along(at_p, start, o, S0 ? *S0 : matrix(matrix::Zero(y0.size(), p.size())));
    sensitivity_result<vector, matrix> r{{run.t(), run.y(), status::success, run.counts(), nullptr},
                                         along.S()};
    try {
        while (r.ok() && run.step()) {
            if (!along.step(run)) {
                r.status = status::newton_failed;
                break;
            }
            r.t = run.t();
            r.y = run.y();
            r.S = along.S();
            if constexpr (!std::is_same_v<std::remove_cvref_t<Observer>, no_observer>)
                if (!observer(r.t, r.y, r.S)) run.stop();
        }
        if (r.ok()) r.status = run.status();
    } catch (const std::invalid_argument&) {
        throw;
    } catch (...) {
        r.status = status::function_threw;
        r.exception = std::current_exception();
    }
    r.report = run.counts();
    return r;
}

/// Other arguments.
sensitivity_result<Eigen::VectorXd, Eigen::MatrixXd> sensitivities(
    detail::refused_call<detail::call_of_sensitivities>, detail::anything, detail::anything, detail::anything,
    detail::anything, detail::anything, const detail::misnamed_options&);
sensitivity_result<Eigen::VectorXd, Eigen::MatrixXd> sensitivities(
    detail::refused_call<detail::call_of_sensitivities>, detail::anything, detail::anything = 0,
    detail::anything = 0, detail::anything = 0, detail::anything = 0, ...);

}  // namespace stagecraft
