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
            "Eigen::Matrix<double, 1, 1>(2.0)), and options have the names that they have for integrate(); "
            "S0 is &S0, n x m numbers, or {.S0 = &S0, .times = {...}, .scale, .control}");
        return true;
    }
};

template <class Method, class Problem, class Vector, class Parameters, class Changes, class Observer>
auto run_with_sensitivities(const Method& method, const Problem& problem, const Vector& y0,
                            const Parameters& p, const typename Vector::Scalar& t0,
                            const typename Vector::Scalar& t1, const options<typename Vector::Scalar>& o,
                            const sensitivity_options<Vector, Parameters>& s, const Changes& changes,
                            Observer& observer) {
    [[maybe_unused]] constexpr checked_outputs<Problem, Vector, Parameters> checked;
    using result_type = sensitivity_result<Vector, typename sensitivity_options<Vector, Parameters>::matrix>;
    constexpr bool usable = []<class... One>(const std::tuple<One...>*) {
        return (usable_change<One, Vector, Parameters>() && ...);
    }(static_cast<const Changes*>(nullptr));
    if constexpr (usable) {
        forward_run<Method, Problem, Vector, Parameters, Changes> run(method, problem, p, y0, t0, t1, o, s,
                                                                      changes);
        return run(t0, y0, observer);
    } else {
        return result_type{};
    }
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
/// sensitivities_with_events() is for. (Where f jumps at given times, options.break_points is right.)
///
/// problem  problem(t, y, p, f) writes f(t, y, p); y, p, f are Eigen's vectors. Optional: jacobian(t, y, p, J) (else
///          as in integrate()), parameter_jacobian(t, y, p, F) with F n x m, dense or Eigen::SparseMatrix (else
///          automatic differentiation, for which the callable must be generic), mass(p), generic in p, and the members
///          that do not depend on p: mass(), index(), bandwidth(), sparsity(), linear_solver.
/// method   A transformed_tableau other than Radau IA, or a set of such (radau_iia_variable()).
/// S0       &S0 with S0 = dy0/dp, or sensitivity_options with .S0 among them; zero if it is left out. Its algebraic
///          components are made consistent where those of the problem are of index 1, so that they need not be given. Where
///          they are not, methods that do not forget them (Gauss) are refused unless S0 is given.
/// observer Called as observer(t, y, S) after every step, if given; where it returns false the run ends. at(times, action) or
///          event(g, options, action) in its place is what sensitivities_with_events() takes.
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
    using matrix = typename sensitivity_options<vector, parameters>::matrix;
    using scalar = typename vector::Scalar;
    using observer_type = std::remove_cvref_t<Observer>;
    if constexpr (!whole || !differentiable) {
        return sensitivity_result<vector, matrix>{};
    } else if constexpr (detail::are_changes<observer_type>) {
        no_observer none;
        return detail::run_with_sensitivities(method, problem, vector(y0), parameters(p), t0, t1, o, s,
                                              detail::as_changes(observer), none);
    } else {
        constexpr bool sees = std::is_same_v<observer_type, no_observer> ||
                              std::is_invocable_v<Observer&, const scalar&, const vector&, const matrix&>;
        static_assert(sees,
                      "sensitivities: the observer must be callable as observer(t, y, S) and return a bool; "
                      "what changes the state stands there, or in the place of the events of "
                      "sensitivities_with_events, as at(times, action) or event(g, options, action), without "
                      "events<Vector>() and observers() around, or as a std::tuple of several");
        if constexpr (sees)
            return detail::run_with_sensitivities(method, problem, vector(y0), parameters(p), t0, t1, o, s,
                                                  std::tuple<>(), observer);
        else
            return sensitivity_result<vector, matrix>{};
    }
}

/// The same across what changes the state or the equations on the way, where S jumps (Rozenwasser-Yusupov 2000,
/// Galan-Feehery-Barton 1999, Hiskens-Pai 2000). `events` is one of these, or a std::tuple of several:
///
///     at(times, action)                 at given times: doses, resets, of any problem
///     event(g, options, action)         where g(t, y) or g(t, y, p) passes zero; without an action too (.terminal)
///     sensitivity_event(g, options, jump, change)   the same with jump(t, y, p, after) and change(problem)
///
///     sensitivities_with_events(radau_iia<3>(), f, y0, p, 0, 72, at(every(24.0), [](const auto&, auto& y, const auto& p) {
///         y[0] += p[1];
///     }))
///
/// action(t, y, p) or action(t, y) changes y to A(t, y, p). At a given time S := A_y S + A_p. At an event, at time tau with
/// g(tau, y(tau), p) = 0,
///
///     dtau/dp = -(g_y S + g_p) / (g_t + g_y f),    S := A_y S + A_p + (A_t + A_y f - f_after) dtau/dp,
///
/// with f before the event and f_after behind it, of the problem as `change`, or what the action sets that f holds by
/// reference, leaves it. result.events has all of them, with dtau/dp and the derivative of the state there, both as
/// total derivatives. So what depends on an event, or on an end t1 = t1(p), is had from a terminal one: g = t - p[0], say.
///
/// g and actions that are generic in y and p (const auto&, auto&) are called once, in reverse_numbers, and differentiated
/// exactly; others by central differences, in some calls for each component, whose error result.events tells: then they must do
/// the same at each call.
///
/// tau is found on the continuous solution (observe/event.hpp), and the step up to it made anew, so that y and S have the
/// accuracy of the ends of steps there. Of two equal sensitivity_options::times where y changes the first has what was
/// before, a single one what is behind. Of several events at one time each acts, in the order of the list. With a singular M, of
/// index 1, algebraic components follow behind each change; at events M is diagonal, and f generic in t.
///
/// What has no derivative ends the run with status::function_threw and a std::domain_error that says so: a grazing
/// event, events that take place together and not so for all p near, an event at the time of an at(), an action with a
/// kink there, problems of index 2 and 3 with events. Events without end in a moment: status::chattering. An event at t1 itself,
/// to rounding, is none of the run's: y and S are those before it.
/// std::invalid_argument of an event .at_start, which may lie before t0 for other p.
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
    constexpr bool differentiable = detail::parameter_derivatives<Problem, vector, parameters>::exist;
    static_assert(
        differentiable,
        "sensitivities_with_events: problem(t, y, p, f) must be generic in its scalar (const auto& t, const "
        "auto& y, const auto& p, auto& f), or the problem have a member parameter_jacobian(t, y, p, F)");
    constexpr bool good = detail::are_changes<Events>;
    static_assert(
        good,
        "sensitivities_with_events: events are at(times, action), event(g, options, action) or "
        "sensitivity_event(g, options, jump, change), without events<Vector>() around, or a std::tuple "
        "of several");
    if constexpr (!whole || !differentiable || !good)
        return sensitivity_result<vector, typename sensitivity_options<vector, parameters>::matrix>{};
    else
        return detail::run_with_sensitivities(method, problem, vector(y0), parameters(p), t0, t1, o, s,
                                              detail::as_changes(events), observer);
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
