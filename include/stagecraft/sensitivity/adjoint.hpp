// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/integrate.hpp>
#include <stagecraft/sensitivity/adjoint_run.hpp>
#include <stagecraft/sensitivity/functionals.hpp>
#include <stagecraft/sensitivity/parameters.hpp>

namespace stagecraft {

/// The result of a run with the value of a functional and the gradient of that.
template <class Vector, class Parameters>
struct gradient_result : result<Vector> {
    typename Vector::Scalar value{0};
    Vector dy0{};     ///< dg/dy0
    Parameters dp{};  ///< dg/dp
    Vector
        dy0_error{};  ///< about the errors of these, component by component; NaN where they are not estimated
    Parameters dp_error{};
    std::string message{};  ///< of status::wrong_derivative: what disagrees, and where
};

/// The same of K functionals: a column each.
template <class Vector, class Parameters, int K>
struct gradients_result : result<Vector> {
    using scalar = typename Vector::Scalar;
    Eigen::Matrix<scalar, K, 1> value = Eigen::Matrix<scalar, K, 1>::Zero();
    Eigen::Matrix<scalar, Vector::RowsAtCompileTime, K> dy0{}, dy0_error{};
    Eigen::Matrix<scalar, Parameters::RowsAtCompileTime, K> dp{}, dp_error{};
    std::string message{};
};

/// What adjoint_gradient() may be told beyond the options of the run.
struct gradient_options {
    bool estimate = true;  ///< of the gradient's error; costs two to three times the rest
};

namespace detail {

struct call_of_adjoint_gradient {
    template <class Method>
    static constexpr bool say() {
        static_assert(
            transformed_method<Method> || never<Method>,
            "adjoint_gradient: the first argument must be a transformed_tableau or a variable_order "
            "set, radau_iia<3>() with its parentheses, say");
        static_assert(
            !transformed_method<Method> || never<Method>,
            "adjoint_gradient(method, problem, y0, p, t0, t1, g, options): the problem must be callable as "
            "problem(t, y, p, f), y0 and p be column vectors of Eigen's (one parameter too: "
            "Eigen::Matrix<double, 1, 1>(2.0)), and options have the names that they have for integrate()");
        return true;
    }
};

/// The gradients of a tuple of functionals, one of end_value, data_sum or time_integral each.
template <class Method, class Problem, class Vector, class Parameters, class Changes, class... Functionals>
auto adjoint_gradients(const Method& method, const Problem& problem, const Vector& y0, const Parameters& p,
                       const typename Vector::Scalar& t0, const typename Vector::Scalar& t1,
                       const std::tuple<Functionals...>& functionals, const Changes& changes,
                       const options<typename Vector::Scalar>& o, const gradient_options& g) {
    using scalar = typename Vector::Scalar;
    constexpr int K = sizeof...(Functionals);
    using bound = at_parameters<Problem, Parameters>;
    const bound at_p(problem, p);
    gradients_result<Vector, Parameters, K> r{{t0, y0, status::success, {}, nullptr}};
    r.dy0.setZero(y0.size(), K);
    r.dp.setZero(p.size(), K);
    r.dy0_error.setConstant(y0.size(), K, std::numeric_limits<scalar>::quiet_NaN());
    r.dp_error.setConstant(p.size(), K, std::numeric_limits<scalar>::quiet_NaN());
    adjoint_run<Method, bound, Vector, std::tuple<Functionals...>, Changes> run(
        method, at_p, y0, t0, t1, functionals, changes, o, g.estimate);
    try {
        run.forward(r);
        if (!(r.ok() || r.status == status::event) || !run.backward(r)) return r;
        const auto& coarse = run.states();
        const auto& fine = run.finer_states();
        for (int k = 0; k < K; ++k) {
            const auto& one = coarse[static_cast<std::size_t>(k)];
            r.value[k] = one.value;
            r.dy0.col(k) = one.lambda;
            r.dp.col(k) = one.mu;
            if (!run.estimates()) continue;
            r.dy0_error.col(k) = (one.lambda - fine[static_cast<std::size_t>(k)].lambda).cwiseAbs();
            r.dp_error.col(k) = (one.mu - fine[static_cast<std::size_t>(k)].mu).cwiseAbs();
        }
    } catch (const std::invalid_argument&) {
        throw;
    } catch (...) {
        r.status = status::function_threw;
        r.exception = std::current_exception();
    }
    return r;
}

/// What is wrong with something that is to happen in a run forward and back is said here, at compile time.
template <class One, class Problem, class Vector, class Parameters>
constexpr bool adjoint_change() {
    using call = call_derivatives<Vector, Parameters>;
    constexpr bool usable = usable_change<One, Vector, Parameters>();
    constexpr bool generic = [] {
        if constexpr (usable && is_located<One>)
            return call::template generic<decltype(behind(std::declval<const One&>()))> &&
                   call::template generic<event_value<std::remove_cvref_t<decltype(One::g)>>>;
        else if constexpr (usable)
            return call::template generic<decltype(behind(std::declval<const One&>()))>;
        else
            return true;
    }();
    static_assert(
        generic,
        "adjoint_gradient_with_events: g and the action must be generic in y and p: [](const auto& t, "
        "auto& y, const auto& p) { y[0] += p[0]; }");
    constexpr bool plain = !is_located<One> || !has_mass<at_parameters<Problem, Parameters>>;
    static_assert(plain,
                  "adjoint_gradient_with_events: events of a problem with mass() are differentiated by "
                  "sensitivities_with_events() alone; at(times, action) by both");
    return usable && generic && plain;
}

/// adjoint_gradient() of a run with a tuple of changes.
template <class Method, class Problem, class Vector, class Parameters, class Functional, class Changes>
auto gradient_with(const Method& method, const Problem& problem, const Vector& y0, const Parameters& p,
                   const typename Vector::Scalar& t0, const typename Vector::Scalar& t1, const Functional& g,
                   const Changes& changes, const options<typename Vector::Scalar>& o,
                   const gradient_options& more) {
    using derivatives = parameter_derivatives<Problem, Vector, Parameters>;
    constexpr bool whole = !in_parts<Problem>;
    static_assert(whole,
                  "adjoint_gradient: of the whole right-hand side: write the sum of the "
                  "parts of split(f_explicit, f_implicit)");
    constexpr bool differentiable = derivatives::exist || derivatives::adjoint_given;
    static_assert(
        differentiable,
        "adjoint_gradient: problem(t, y, p, f) must be generic in its scalar (const auto& t, const auto& y, "
        "const auto& p, auto& f), or the problem have a member parameter_jacobian(t, y, p, F) or "
        "parameter_adjoint(t, y, p, v, q)");
    [[maybe_unused]] constexpr checked_outputs<Problem, Vector, Parameters> checked;
    const auto list = [&] {
        if constexpr (is_tuple<Functional>)
            return std::apply([](const auto&... one) { return std::tuple(as_functional(one)...); }, g);
        else
            return std::tuple(as_functional(g));
    }();
    constexpr bool usable = []<class... One>(const std::tuple<One...>*) {
        return (adjoint_change<One, Problem, Vector, Parameters>() && ...);
    }(static_cast<const Changes*>(nullptr));
    if constexpr (!whole || !differentiable || !usable) {
        return gradient_result<Vector, Parameters>{};
    } else {
        auto all = adjoint_gradients(method, problem, y0, p, t0, t1, list, changes, o, more);
        if constexpr (is_tuple<Functional>) {
            return all;
        } else {
            return gradient_result<Vector, Parameters>{{all.t, all.y, all.status, all.report, all.exception},
                                                       all.value[0],
                                                       all.dy0,
                                                       all.dp,
                                                       all.dy0_error,
                                                       all.dp_error,
                                                       all.message};
        }
    }
}

}  // namespace detail

/// Integrates M y' = f(t, y, p) and differentiates functionals of the solution with respect to y0 and p, at a
/// cost that does not grow with the number of parameters: by the discrete adjoint, every accepted step transposed and
/// taken back from the end. The step sizes are held fixed, so that this is, to rounding, the gradient of g of the numerical
/// solution, the one that sensitivities() would give with the same steps; as there, f must have derivatives along the
/// solution.
///
/// A Runge-Kutta method of order p has a discrete adjoint of order p (Sandu 2006): where no b_i is zero it is the method
/// b_i, b_j - b_j a_ji / b_i for the adjoint equation, together with which the method is symplectic (Hager 2000,
/// Sanz-Serna 2016). On stiff equations its stages are those of another method, of another stage order: for Radau IIA of
/// Radau IA, s - 1, so that the gradient may fall behind the solution between those of p in stiff components.
///
/// The steps are those of y, whatever the gradient needs. What its error is about is told in dy0_error and dp_error: what the
/// gradient changes by where all steps are halved, from the beginning to the end. It is an estimate and no bound; where it is
/// not small beside the gradient, a smaller tolerance or options.max_step helps. gradient_options{.estimate = false} leaves
/// it out.
///
/// problem, p, method as in sensitivities(). (df/dp)^T v and (df/dy)^T v come from a tape of one call of f in
/// reverse_numbers for every stage, 24 bytes an operation; or, where f is not generic, from jacobian(), which is compared with
/// differences of f, and parameter_adjoint(t, y, p, v, q), which writes (df/dp)^T v into q, or parameter_jacobian(t, y, p, F).
/// g        One functional: a g(y) or g(y, p) of the end, at_end(g), sum_over(times, g), integral_of(g)
///          (functionals.hpp); or a std::tuple of such, of which the result is a gradients_result with a column each.
///
/// dy0 is the derivative by y0 as a whole; with a method that does not forget the algebraic components of the start (Gauss) and
/// index 1 these follow from the others, as in sensitivities(). mass() must show its entries.
///
/// Memory: the square root of the number of steps, twice, in checkpoints and in steps, which are made again from them, bit by
/// bit; the tapes of one step; never an n x m matrix. Costs the run twice, and for every step s calls of f on tape, a Jacobian,
/// a factorisation and some ten solves a functional; three to four times that with the estimate. Where the run
/// does not end with success there is no gradient (zeros); status::newton_failed if a step's linear equations are not
/// solved, status::wrong_derivative as in sensitivities(). std::invalid_argument as integrate().
template <class Method, class Problem, class DerivedY, class DerivedP, class Functional>
requires detail::run_with_parameters<Method, Problem, typename DerivedY::PlainObject,
                                     typename DerivedP::PlainObject>
auto adjoint_gradient(const Method& method, const Problem& problem, const Eigen::MatrixBase<DerivedY>& y0,
                      const Eigen::MatrixBase<DerivedP>& p,
                      std::type_identity_t<typename DerivedY::Scalar> t0,
                      std::type_identity_t<typename DerivedY::Scalar> t1, const Functional& g,
                      const options<typename DerivedY::Scalar>& o = {}, const gradient_options& more = {}) {
    using vector = typename DerivedY::PlainObject;
    using parameters = typename DerivedP::PlainObject;
    constexpr bool functional = detail::differentiable_functionals<Functional, vector, parameters>();
    static_assert(functional,  // here, not in a function below: each call between adds lines to the message
                  "adjoint_gradient: g is called with a vector of reverse numbers and must accept any scalar "
                  "and return a number, not a product of Eigen's: [](const auto& y) { return y.dot(y); }");
    if constexpr (functional)
        return detail::gradient_with(method, problem, vector(y0), parameters(p), t0, t1, g, std::tuple<>(), o,
                                     more);
    else
        return gradient_result<vector, parameters>{};
}

/// The same across what changes the state on the way: `events` is at(times, action), event(g, options, action),
/// sensitivity_event(g, options, jump, change), or a std::tuple of such, as for sensitivities_with_events(), of whose S this is
/// the transposed. g and actions are generic in y and p.
///
/// On the way back no action is done: what f is before and behind one may differ by change(problem) of sensitivity_event()
/// alone, or by t. An action that sets what f holds by reference is found out, and refused (std::domain_error,
/// status::function_threw), as are several events at one time, and what sensitivities_with_events() refuses. With events
/// errors are not estimated (NaN), with at() they are. Events of problems with mass() do not compile; with at() algebraic
/// components of index 1 follow behind each change. A functional has the state behind a change at its time; at a terminal
/// event, which ends the run with status::event, it is differentiated with the time of that. Costs beyond
/// adjoint_gradient() a new start a change, and a copy of the problem.
template <class Method, class Problem, class DerivedY, class DerivedP, class Events, class Functional>
requires detail::run_with_parameters<Method, Problem, typename DerivedY::PlainObject,
                                     typename DerivedP::PlainObject>
auto adjoint_gradient_with_events(const Method& method, const Problem& problem,
                                  const Eigen::MatrixBase<DerivedY>& y0, const Eigen::MatrixBase<DerivedP>& p,
                                  std::type_identity_t<typename DerivedY::Scalar> t0,
                                  std::type_identity_t<typename DerivedY::Scalar> t1, const Events& events,
                                  const Functional& g, const options<typename DerivedY::Scalar>& o = {},
                                  const gradient_options& more = {}) {
    using vector = typename DerivedY::PlainObject;
    using parameters = typename DerivedP::PlainObject;
    constexpr bool good = detail::are_changes<Events>;
    static_assert(
        good,
        "adjoint_gradient_with_events: events are at(times, action), event(g, options, action) or "
        "sensitivity_event(g, options, jump, change), without events<Vector>() around, or a std::tuple "
        "of several");
    constexpr bool functional = detail::differentiable_functionals<Functional, vector, parameters>();
    static_assert(
        functional,
        "adjoint_gradient_with_events: g is called with a vector of reverse numbers and must accept "
        "any scalar and return a number, not a product of Eigen's: [](const auto& y) { return "
        "y.dot(y); }");
    if constexpr (good && functional)
        return detail::gradient_with(method, problem, vector(y0), parameters(p), t0, t1, g,
                                     detail::as_changes(events), o, more);
    else
        return gradient_result<vector, parameters>{};
}

/// Other arguments.
gradient_result<Eigen::VectorXd, Eigen::VectorXd> adjoint_gradient(
    detail::refused_call<detail::call_of_adjoint_gradient>, detail::anything, detail::anything,
    detail::anything, detail::anything, detail::anything, detail::anything, const detail::misnamed_options&);
gradient_result<Eigen::VectorXd, Eigen::VectorXd> adjoint_gradient(
    detail::refused_call<detail::call_of_adjoint_gradient>, detail::anything, detail::anything = 0,
    detail::anything = 0, detail::anything = 0, detail::anything = 0, detail::anything = 0, ...);

}  // namespace stagecraft
