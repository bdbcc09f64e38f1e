// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <stagecraft/observe/at.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/owned_value.hpp>
#include <stagecraft/sensitivity/functionals.hpp>
#include <stagecraft/sensitivity/state_events.hpp>

// What may happen in a run with derivatives: sensitivity_event(), event() and at(), as calls of (t, y, p).
namespace stagecraft::detail {

/// "who: at t = ... what"
template <class Scalar>
[[noreturn]] void no_derivative(const char* who, const Scalar& t, const std::string& what) {
    std::ostringstream text;
    text.precision(std::numeric_limits<Scalar>::max_digits10);
    text << who << ": at t = " << t << ' ' << what;
    throw std::domain_error(text.str());
}

template <class T>
inline constexpr bool is_plain_event = false;
template <class G, class Action>
inline constexpr bool is_plain_event<event_function<G, Action>> = true;
template <class T>
inline constexpr bool is_timed = false;
template <class Scalar, class Action>
inline constexpr bool is_timed<timed_action<Scalar, Action>> = true;
template <class T>
inline constexpr bool is_located = is_state_event<T> || is_plain_event<T>;

template <class T>
inline constexpr bool are_changes = is_located<T> || is_timed<T>;
template <class... T>
inline constexpr bool are_changes<std::tuple<T...>> = sizeof...(T) > 0 &&
                                                      ((is_located<T> || is_timed<T>)&&...);
template <class T>
inline constexpr bool one_located = is_located<T>;
template <class... T>
inline constexpr bool one_located<std::tuple<T...>> = (is_located<T> || ...);

/// One of them, or several, as a tuple.
template <class Changes>
auto as_changes(const Changes& list) {
    if constexpr (is_tuple<Changes>)
        return list;
    else
        return std::tuple(list);
}

/// g(t, y, p) or g(t, y) as a vector of one number.
template <class G>
struct event_value {
    const G& g;
    template <class T, class Y, class P>
    static constexpr bool takes = callable_unconverted<const G, const T&, const Y&, const P&> ||
                                  callable_unconverted<const G, const T&, const Y&>;
    template <class T, class Y, class P>
    auto operator()(const T& t, const Y& y, const P& p) const {
        Eigen::Matrix<typename Y::Scalar, 1, 1> value;
        value[0] = number(t, y, p);
        return value;
    }
    template <class T, class Y, class P>
    auto number(const T& t, const Y& y, const P& p) const {
        return with_parameters(g, p, t, y);
    }
};

/// The state behind a change: by action(t, y, p) or action(t, y), which change y, or by jump(t, y, p, after).
template <class Action>
struct state_behind {
    const Action& action;
    template <class T, class Y, class P>
    static constexpr bool takes = callable_unconverted<const Action, const T&, Y&, const P&> ||
                                  callable_unconverted<const Action, const T&, Y&>;
    template <class T, class Y, class P>
    Y operator()(const T& t, const Y& y, const P& p) const {
        Y after = y;
        if constexpr (std::is_invocable_v<const Action&, const T&, Y&, const P&>)
            action(t, after, p);
        else
            action(t, after);
        return after;
    }
};
template <class Jump>
struct jump_behind {
    const Jump& jump;
    template <class T, class Y, class P>
    static constexpr bool takes = callable_unconverted<const Jump, const T&, const Y&, const P&, Y&>;
    template <class T, class Y, class P>
    Y operator()(const T& t, const Y& y, const P& p) const {
        Y after = y;
        jump(t, y, p, after);
        return after;
    }
};
struct nothing_behind {
    template <class T, class Y, class P>
    static constexpr bool takes = true;
    template <class T, class Y, class P>
    Y operator()(const T&, const Y& y, const P&) const {
        return y;
    }
};

template <class G, class Jump, class Change>
auto behind(const state_event<G, Jump, Change>& one) {
    return jump_behind<Jump>{one.jump};
}
template <class G, class Action>
auto behind(const event_function<G, Action>& one) {
    if constexpr (std::is_same_v<Action, no_action>)
        return nothing_behind();
    else
        return state_behind<Action>{one.action};
}
template <class Scalar, class Action>
auto behind(const timed_action<Scalar, Action>& one) {
    return state_behind<Action>{one.action()};
}

/// Makes the problem the one that holds behind an event.
template <class One, class Problem>
void change_problem(const One& one, Problem& problem) {
    if constexpr (is_state_event<One>) one.change(problem);
}

/// What is wrong with one of them is said here, at compile time.
template <class One, class Vector, class Parameters>
constexpr bool usable_change() {
    using scalar = typename Vector::Scalar;
    if constexpr (is_located<One>) {
        using G = decltype(One::g);
        constexpr bool callable =
            std::is_invocable_v<const G&, const scalar&, const Vector&, const Parameters&> ||
            std::is_invocable_v<const G&, const scalar&, const Vector&>;
        static_assert(callable, "events of sensitivities: g must be callable as g(t, y) or g(t, y, p)");
        if constexpr (callable) {
            using value =
                decltype(with_parameters(std::declval<const G&>(), std::declval<const Parameters&>(),
                                         std::declval<const scalar&>(), std::declval<const Vector&>()));
            static_assert(owned_number<value>,
                          "sensitivity_event: g returns a product of Eigen's, whose operands may be gone "
                          "before it is evaluated: write n.dot(y), or (n.transpose() * y).value()");
            static_assert(!std::is_same_v<value, bool>,
                          "events of sensitivities: g returns a bool, whose change of sign is none: return "
                          "the number that passes zero, y[0] - 1 for y[0] > 1");
        }
    }
    using call = decltype(behind(std::declval<const One&>()));
    constexpr bool changes = call::template takes<scalar, Vector, Parameters>;
    static_assert(
        changes,
        "changes of sensitivities: the action must be callable as action(t, y) or action(t, y, p), y a "
        "reference to the state, auto& or Eigen::Vector3d&, which it changes, and const itself");
    return changes;
}

/// std::invalid_argument of an event .at_start.
template <class... Changes>
void demand_no_event_at_start(const std::tuple<Changes...>& list) {
    const auto look = [](const auto& one) {
        if constexpr (is_located<std::remove_cvref_t<decltype(one)>>)
            if (one.options.at_start)
                throw std::invalid_argument(
                    "events of sensitivities: an event .at_start has no derivative: it may lie before t0 for "
                    "other p");
    };
    std::apply([&](const auto&... one) { (look(one), ...); }, list);
}

/// The times of all at() of a list.
template <class Scalar, class... Changes>
break_times<Scalar> times_of_changes(const std::tuple<Changes...>& list) {
    break_times<Scalar> all;
    const auto add = [&](const auto& one) {
        if constexpr (is_timed<std::remove_cvref_t<decltype(one)>>)
            all.add(break_times<Scalar>(one.break_points()));
    };
    std::apply([&](const auto&... one) { (add(one), ...); }, list);
    return all;
}

/// What finds the events of a list, at these parameters; nothing where there are none. Their numbers are their places.
template <class Parameters, class Vector, class... Changes>
auto watch_for(const Parameters& p, const std::tuple<Changes...>& list, const Vector&) {
    if constexpr (!(is_located<Changes> || ...)) {
        return 0;
    } else {
        using watch = event_watch<Vector>;
        using scalar = typename Vector::Scalar;
        std::vector<event_function<typename watch::function>> all;
        const auto add = [&](const auto& one) {
            if constexpr (is_located<std::remove_cvref_t<decltype(one)>>)
                all.push_back({[&p, &one](const scalar& t, const Vector& y) {
                                   return scalar(with_parameters(one.g, p, t, y));
                               },
                               {one.options.direction, false},
                               {}});
            else
                all.push_back({[](const scalar&, const Vector&) { return scalar(1); }, {}, {}});
        };
        std::apply([&](const auto&... one) { (add(one), ...); }, list);
        return watch(std::move(all));
    }
}

}  // namespace stagecraft::detail
