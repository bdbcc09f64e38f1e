// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stdexcept>
#include <type_traits>
#include <utility>

#include <stagecraft/observe/acting_events.hpp>
#include <stagecraft/observe/event_watch.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/refuse/detect/refused_call.hpp>
#include <stagecraft/refuse/detect/taken_arguments.hpp>

namespace stagecraft {

/// The event "g(t, y) reaches or crosses zero" for a continuous g, which returns a number; events() says
/// how zeros are found, what that costs, and what a NaN does. In a distributed run (problem.add_up) y is the part of one
/// process: g has to return the same number on all, from sums of its own. Where the numbers differ, a terminal event still
/// ends the run on all processes, but only those that saw it end at its time.
template <class Function>
event_function<Function> event(Function g, event_options o = {}) {
    return {std::move(g), o, {}};
}

/// The same, and what is to be done there: action(t, y) changes y, or parameters that the problem holds by reference, and
/// the run goes on from there as one that begins; events() says the rules:
///
///     event([](double, const Vector2d& y) { return y[0]; }, {.direction = crossing::falling},
///           [](double, Vector2d& y) { y[1] *= -0.9; })
///
/// std::invalid_argument where the event is terminal as well.
template <class Function, class Action>
event_function<Function, Action> event(Function g, event_options o, Action action) {
    if (o.terminal)
        throw std::invalid_argument(
            "event: a terminal event ends the run and leaves nothing to be done: give .terminal or an "
            "action");
    return {std::move(g), o, std::move(action)};
}

namespace detail {
struct call_of_event {
    template <class T>
    static constexpr bool say() {
        static_assert(never<T>,
                      "event(g, options, action): options are {.direction = crossing::falling, .terminal = "
                      "true}, where direction is crossing::both, crossing::rising or crossing::falling (of "
                      "stagecraft); an action(t, y) stands third, behind options or {}");
        return true;
    }
};
}  // namespace detail

/// Options of other names or types.
event_function<std::nullptr_t> event(detail::refused_call<detail::call_of_event>, detail::misnamed_options);
event_function<std::nullptr_t> event(detail::refused_call<detail::call_of_event>, ...);

namespace detail {
template <class Function, class Vector>
constexpr bool returns_bool = requires(Function& g, const typename Vector::Scalar& t, const Vector& y) {
    { g(t, y) } -> std::same_as<bool>;
};
}  // namespace detail

/// An observer that locates events on the continuous solution, e.g.
///
///     auto watch = events<Vector2d>(event(height, {.terminal = true}), event(speed));
///     const auto r = integrate(method, problem, y0, t0, t1, options, watch);  // then watch.found()
///
/// Vector is the type of the state and must be written out. The first terminal event ends the run:
/// result.status is status::event, result.t and result.y are the time and the state of the event, or of the
/// last one that only rounding of t (four epsilon) separates from it. Events are reported in the order of the
/// run, simultaneous ones in the order of the list.
///
/// Each g(t, y) is evaluated at 2 s points of every step (at least four) and, where it comes near zero, at a
/// few more, which reveal pairs of crossings. Each crossing is narrowed down to the rounding of t; its
/// accuracy is that of the continuous solution (dense_output.hpp). Missed may be a pair closer than about
/// 1/5000 of a step, a pair with a third crossing as near as the next sample, and a g that oscillates within
/// a step: options.max_step helps. g may be evaluated anywhere in a step, also beyond a terminal event.
///
/// The time reported is the first at which g is zero or has its new sign, so that a run continued from there
/// does not meet the same event again; an event within rounding of t0 is not reported. A smooth g that
/// reaches zero to rounding and turns back is an event. A g that returns NaN ends the run with status::function_threw
/// (std::domain_error naming the event and t).
///
/// A ball that bounces to rest bounces infinitely often in finite time. Its flights become shorter than t can
/// resolve, and then it leaves the floor no more: what begins on the far side of zero meets no event, and the ball
/// falls through. Whoever makes it bounce has to end it: where the speed v after a bounce no longer matters, or
/// at the latest where the flight of 2 v/g that follows is below some 1e-12 of t, the ball lies still, and the
/// run goes on without that degree of freedom.
///
/// Where an event has an action (event(g, options, action)) the step is cut at it, all observers are told it up to there, and
/// then y changes; observe/at.hpp says what tables and solutions hold of the two values. Events that take place together
/// act in the order of the list; if one of them is terminal the run ends, and nothing is done. The event that has just acted
/// is not found again at the zero where its change leaves it; others are, if they go through zero from there. g that a change
/// carries over zero has not crossed it. An action that leaves y not finite or of another size, or that throws, ends the
/// run in status::function_threw at the state before it.
///
/// Where the same events take place more than four times within 1e-11 of t (or of t - t0, if that is more) the run ends in
/// status::chattering, and alternating() names them: a ball that bounces to rest, or a solution that slides along the zeros
/// of the g that switch it, which no sequence of events describes. In the first case end it at a small speed; in the second replace
/// f by what it is on the surface, or smooth the switch. Each direction of a switch is an event of its own: one that
/// acts in both cannot tell sliding from touching.
template <class Vector, class... Functions, class... Actions>
requires requires { typename Vector::Scalar; }
auto events(event_function<Functions, Actions>... list) {
    using function = typename event_watch<Vector>::function;
    using scalar = typename Vector::Scalar;
    constexpr bool callable = (std::is_constructible_v<function, Functions> && ...) &&
                              !(detail::mistakes_vectors<Functions, const scalar&, const Vector&>() || ...);
    static_assert(
        callable,
        "events: g in event(g) must be callable as g(t, y), y const or by value and of the type named in "
        "events<Vector>, and return a number");
    constexpr bool numbers = !(detail::returns_bool<Functions, Vector> || ...);
    static_assert(
        numbers,
        "events: g in event(g) returns a bool, whose change of sign is none: return the number that "
        "passes zero, y[0] - 1 for y[0] > 1");
    constexpr bool objects = [] {
        if constexpr (callable && numbers)
            return (detail::owned_or_none<Functions&, const scalar&, const Vector&> && ...);
        else
            return true;
    }();
    static_assert(
        objects,
        "events: g in event(g) returns a product of Eigen's, whose operands may be gone before it is "
        "evaluated: write n.dot(y), or (n.transpose() * y).value()");
    constexpr bool acts = !(std::is_same_v<Actions, no_action> && ...);
    constexpr bool good_actions =
        ((std::is_same_v<Actions, no_action> || std::is_invocable_v<Actions&, const scalar&, Vector&>)&&...);
    static_assert(good_actions,
                  "events: the action in event(g, options, action) must be callable as action(t, y), y a "
                  "reference to the type named in events<Vector>, which it changes");
    if constexpr (callable && numbers && objects && acts && good_actions)
        return acting_event_watch<Vector>(
            {event_function<function>{function(std::move(list.g)), list.options, {}}...},
            {detail::action_function<Vector>(std::move(list.action))...});
    else if constexpr (callable && numbers && objects)
        return event_watch<Vector>(
            {event_function<function>{function(std::move(list.g)), list.options, {}}...});
    else
        return event_watch<Vector>({});
}

namespace detail {
/// What events() returns that has been refused: nothing more is said about it.
struct refused_events : event_watch<Eigen::VectorXd> {
    refused_events() : event_watch({}) {}
    void operator()(const auto&...) {}
};
}  // namespace detail

/// Without the type of the state it does not compile, nor without event().
template <class Vector = detail::unstated, class... Events>
requires(!requires(const Events&... e) {
    typename Vector::Scalar;
    (e.options, ...);
}) detail::refused_events events(const Events&...) {
    static_assert(
        detail::never<Vector>,
        "events: write events<Vector2d>(event(g)), with the type of the state and event() around g");
    return {};
}

}  // namespace stagecraft
