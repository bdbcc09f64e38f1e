// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <tuple>
#include <type_traits>
#include <utility>

#include <stagecraft/integrate.hpp>
#include <stagecraft/sensitivity/forward_run.hpp>
#include <stagecraft/sensitivity/forward_steps.hpp>
#include <stagecraft/sensitivity/parameters.hpp>

namespace stagecraft {

namespace detail {

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

template <class Method, class Problem, class Vector, class Parameters, class Events, class Observer>
auto run_with_sensitivities(const Method& method, const Problem& problem, const Vector& y0,
                            const Parameters& p, const typename Vector::Scalar& t0,
                            const typename Vector::Scalar& t1, const options<typename Vector::Scalar>& o,
                            const sensitivity_options<Vector, Parameters>& s, const Events& events,
                            Observer& observer) {
    [[maybe_unused]] constexpr checked_outputs<Problem, Vector, Parameters> checked;
    forward_run<Method, Problem, Vector, Parameters, Events> run(method, problem, p, t1, o, s, events);
    return run(t0, y0, observer);
}

}  // namespace detail

/// Integrates M y' = f(t, y, p) together with its sensitivities S = dy/dp, M S' = f_y S + f_p, S(t0) = S0.
///
/// Staggered and direct (Caracotsios-Stewart 1985): with every step of y the same step is made with
/// S, whose stage equations are linear; they are solved to rounding with the factors that the step of y has used (within
/// rtol where these or rounding errors of a large h f_y allow no more). So S is the derivative of the numerical solution
/// with respect to p, the step sizes held fixed, and converges with the order of y in all components, algebraic ones
/// included.
///
/// The steps are such that the errors of y and of S are within their tolerances, in column k of S rtol |S_ik| + atol_i /
/// |p_k| (sensitivity_options; as CVODES does with errconS). Without that (.control = false) they are those of y alone:
/// where y is at rest they are long whatever S does. Problems with index() of 2 or 3 are
/// controlled in y alone, and with options.fixed_step nothing is. Where S starts off the slow solutions of a stiff problem (S0 =
/// 1, say) its transients are resolved, as those of y are.
///
/// The derivatives are exact: of an f that is generic by automatic differentiation, along the directions of S where the
/// problem brings a jacobian(), sparsity() or bandwidth(), which serve the iteration alone and may be approximate. Where
/// parameter_jacobian is given f need not be generic; its matrices, and jacobian() or the differences within sparsity(), are
/// compared with differences of f in every step, and the run ends with status::wrong_derivative and a sentence in
/// result.message where they disagree (derivative_check.hpp says what is seen).
///
/// f must have derivatives along the solution. Where f jumps at a place that depends on y or p, S jumps as well, by an
/// amount that no derivative of f shows: S is wrong from there on, in a run that ends with success. That is what
/// sensitivities_with_events() is for.
///
/// problem  problem(t, y, p, f) writes f(t, y, p); y, p, f are Eigen's vectors. Optional: jacobian(t, y, p, J) (else
///          as in integrate()), parameter_jacobian(t, y, p, F) with F n x m, dense or Eigen::SparseMatrix (else
///          automatic differentiation, for which the callable must be generic), mass(p), generic in p, and the members
///          that do not depend on p: mass(), index(), bandwidth(), sparsity(), linear_solver.
/// method   A transformed_tableau other than Radau IA, or a set of such (radau_iia_variable()).
/// S0       dy0/dp, zero if it is left out. Its algebraic components are made consistent where those of the problem are of
///          index 1, so that they need not be given. Where they are not, methods that do not forget them (Gauss) are refused
///          unless S0 is given.
/// observer Called as observer(t, y, S) after every step, if given; where it returns false the run ends.
///
/// Costs s + 1 Jacobians and, for each parameter, some ten solves with the factors there are, in every step that is tried, or
/// as many calls of f for a direction in every stage; and the steps that S needs beyond those of y. Memory: n m (s + 3)
/// numbers. A step whose linear equations the factors do not solve ends the run with status::newton_failed.
/// std::invalid_argument as integrate().
template <class Method, class Problem, class DerivedY, class DerivedP, class Observer = no_observer>
requires detail::run_with_parameters<Method, Problem, typename DerivedY::PlainObject,
                                     typename DerivedP::PlainObject>
auto sensitivities(
    const Method& method, const Problem& problem, const Eigen::MatrixBase<DerivedY>& y0,
    const Eigen::MatrixBase<DerivedP>& p, std::type_identity_t<typename DerivedY::Scalar> t0,
    std::type_identity_t<typename DerivedY::Scalar> t1, const options<typename DerivedY::Scalar>& o,
    const std::type_identity_t<
        sensitivity_options<typename DerivedY::PlainObject, typename DerivedP::PlainObject>>& s,
    Observer&& observer = {}) {
    using vector = typename DerivedY::PlainObject;
    using parameters = typename DerivedP::PlainObject;
    constexpr bool whole = !in_parts<Problem>;
    static_assert(whole,
                  "sensitivities: of the whole right-hand side: write the sum of the parts "
                  "of split(f_explicit, f_implicit)");
    constexpr bool differentiable = detail::parameter_derivatives<Problem, vector, parameters>::exist;
    static_assert(
        differentiable,
        "sensitivities: problem(t, y, p, f) must be generic in its scalar (const auto& t, const auto& y, "
        "const auto& p, auto& f), or the problem have a member parameter_jacobian(t, y, p, F)");
    if constexpr (whole && differentiable)
        return detail::run_with_sensitivities(method, problem, vector(y0), parameters(p), t0, t1, o, s,
                                              std::tuple<>(), observer);
    else
        return sensitivity_result<vector, typename sensitivity_options<vector, parameters>::matrix>{};
}

/// The same across events, at which S jumps (Galan-Feehery-Barton 1999); `events` is a sensitivity_event() or a std::tuple of
/// several. At an event of number e, at time tau with g(tau, y(tau), p) = 0,
///
///     dtau/dp = -(g_y S + g_p) / (g_t + g_y f),    S := d/dp y_after - f_after dtau/dp,
///
/// where y_after is the state that the jump makes, along y(tau(p), p), and f_after the right-hand side there, of the problem
/// as `change` leaves it. result.events has the events with dtau/dp and the derivative of the state at the event, both as
/// total derivatives. So what depends on an event, or on an end t1 = t1(p), is had from a terminal one: g = t - p[0], say.
///
/// tau is found on the continuous solution (observe/event.hpp), and the step up to it made anew, so that y and S have the
/// accuracy of the ends of steps there. For y' = f alone (no mass()). A grazing event, whose time has no derivative, ends
/// the run with status::function_threw and a std::domain_error.
template <class Method, class Problem, class DerivedY, class DerivedP, class Events,
          class Observer = no_observer>
requires detail::run_with_parameters<Method, Problem, typename DerivedY::PlainObject,
                                     typename DerivedP::PlainObject>
auto sensitivities_with_events(
    const Method& method, const Problem& problem, const Eigen::MatrixBase<DerivedY>& y0,
    const Eigen::MatrixBase<DerivedP>& p, std::type_identity_t<typename DerivedY::Scalar> t0,
    std::type_identity_t<typename DerivedY::Scalar> t1, const Events& events,
    const options<typename DerivedY::Scalar>& o = {},
    const std::type_identity_t<
        sensitivity_options<typename DerivedY::PlainObject, typename DerivedP::PlainObject>>& s = {},
    Observer&& observer = {}) {
    using vector = typename DerivedY::PlainObject;
    using parameters = typename DerivedP::PlainObject;
    constexpr bool whole = !in_parts<Problem>;
    static_assert(whole,
                  "sensitivities_with_events: of the whole right-hand side: write the sum "
                  "of the parts of split(f_explicit, f_implicit)");
    constexpr bool differentiable = detail::parameter_derivatives<Problem, vector, parameters>::automatic;
    static_assert(
        differentiable,
        "sensitivities_with_events: problem(t, y, p, f) must be generic in its scalar (const auto& t, "
        "const auto& y, const auto& p, auto& f)");
    constexpr bool good = detail::are_events<Events>;
    static_assert(good,
                  "sensitivities_with_events: events are sensitivity_event(g, options, jump, change), or a "
                  "std::tuple of several");
    if constexpr (!whole || !differentiable || !good)
        return sensitivity_result<vector, typename sensitivity_options<vector, parameters>::matrix>{};
    else if constexpr (detail::is_state_event<Events>)
        return detail::run_with_sensitivities(method, problem, vector(y0), parameters(p), t0, t1, o, s,
                                              std::tuple(events), observer);
    else
        return detail::run_with_sensitivities(method, problem, vector(y0), parameters(p), t0, t1, o, s,
                                              events, observer);
}

/// The same with S0, or zero, alone.
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
    sensitivity_options<typename DerivedY::PlainObject, typename DerivedP::PlainObject> s;
    s.S0 = S0;
    return sensitivities(method, problem, y0, p, t0, t1, o, s, std::forward<Observer>(observer));
}

/// Other arguments.
sensitivity_result<Eigen::VectorXd, Eigen::MatrixXd> sensitivities(
    detail::refused_call<detail::call_of_sensitivities>, detail::anything, detail::anything, detail::anything,
    detail::anything, detail::anything, const detail::misnamed_options&);
sensitivity_result<Eigen::VectorXd, Eigen::MatrixXd> sensitivities(
    detail::refused_call<detail::call_of_sensitivities>, detail::anything, detail::anything = 0,
    detail::anything = 0, detail::anything = 0, detail::anything = 0, ...);

}  // namespace stagecraft
