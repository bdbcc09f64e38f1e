// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <type_traits>

#include <stagecraft/named_member.hpp>
#include <stagecraft/taken_arguments.hpp>

namespace stagecraft {

/// The default observer: watches nothing and costs nothing.
///
/// An observer has a call operator and may have further members, which are detected. A member of one of these
/// names that cannot be called in this way does not compile.
///
///   observer(t, y, h, output) or (t, y, h) or (t, y)
///       Called after every accepted step with its end t, the state y there, its length h (negative when time
///       runs backwards) and the continuous solution over it. A return value that converts to bool and is
///       false ends the run with status::stopped.
///   observer.start(t0, y0, t1)
///       Called before the first step. An exception from it leaves integrate().
///   observer.correct(t, y)
///       Called after every accepted step, before the call operator. It may change y and then returns true;
///       the run goes on from the changed state (dae/projection.hpp).
///   observer.save(take)
///       Called after every accepted step, last; take() makes a checkpoint of the run (checkpoint.hpp).
///   observer.conclude(result)
///       Called last. It may shorten the run to an earlier t, and must then do the same when it is called
///       again; what it has kept beyond result.t it discards.
struct no_observer {};

namespace detail {

struct start_member {
    int start;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::start;
    };
};
struct correct_member {
    int correct;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::correct;
    };
};
struct save_member {
    int save;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::save;
    };
};
struct conclude_member {
    int conclude;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::conclude;
    };
};

/// True if the observer can be called with these arguments after t and y.
template <class Observer, class Vector, class... More>
concept observes_with = requires(Observer& observer, const typename Vector::Scalar& t, const Vector& y,
                                 const More&... more) {
    observer(t, y, more...);
}
&&!mistakes_vectors<Observer, const typename Vector::Scalar&, const Vector&, const More&...>();

/// True if the observer is called with the continuous solution.
template <class Observer, class Vector, class Output>
inline constexpr bool asks_for_output = observes_with<Observer, Vector, typename Vector::Scalar, Output>;

/// True if the observer can be called after a step in one of its forms.
template <class Observer, class Vector, class Output>
inline constexpr bool can_observe =
    std::is_same_v<std::remove_const_t<Observer>, no_observer> || asks_for_output<Observer, Vector, Output> ||
    observes_with<Observer, Vector, typename Vector::Scalar> || observes_with<Observer, Vector>;

template <class Observer, class Scalar, class Vector>
void announce([[maybe_unused]] Observer& observer, [[maybe_unused]] const Scalar& t0,
              [[maybe_unused]] const Vector& y0, [[maybe_unused]] const Scalar& t1) {
    constexpr bool callable = requires { observer.start(t0, y0, t1); };
    static_assert(
        callable || !has_member_named<Observer, start_member>,
        "observer.start must be callable as start(t0, y0, t1), the scalars and the state by value or "
        "const reference, and on a const observer where it is given as const");
    if constexpr (callable) observer.start(t0, y0, t1);
}

/// Calls observer(t, y, h, output), observer(t, y, h) or observer(t, y), whichever exists; true means go on.
template <class Observer, class Scalar, class Vector, class Output>
bool observe(Observer& observer, const Scalar& t, const Vector& y, const Scalar& h, const Output& output) {
    const auto call = [&](auto&&... arguments) {
        using returned = std::invoke_result_t<Observer&, decltype(arguments)...>;
        if constexpr (std::is_convertible_v<returned, bool>) {
            return static_cast<bool>(observer(arguments...));
        } else {
            observer(arguments...);
            return true;
        }
    };
    if constexpr (std::is_same_v<std::remove_const_t<Observer>, no_observer>)
        return true;
    else if constexpr (asks_for_output<Observer, Vector, Output>)
        return call(t, y, h, output);
    else if constexpr (observes_with<Observer, Vector, Scalar>)
        return call(t, y, h);
    else
        return call(t, y);
}

template <class Observer, class Scalar, class Vector>
concept correcting_observer = requires(Observer& observer, const Scalar& t, Vector& y) {
    { observer.correct(t, y) } -> std::convertible_to<bool>;
};

/// Lets the observer correct y; true if it did.
template <class Observer, class Scalar, class Vector>
bool correct_state([[maybe_unused]] Observer& observer, [[maybe_unused]] const Scalar& t,
                   [[maybe_unused]] Vector& y) {
    constexpr bool callable = correcting_observer<Observer, Scalar, Vector>;
    static_assert(
        callable || !has_member_named<Observer, correct_member>,
        "observer.correct must be callable as correct(t, y), y a reference to the state, and return "
        "true where it has changed y, else false");
    if constexpr (callable)
        return observer.correct(t, y);
    else
        return false;
}

/// Lets the observer correct the state of the run, in y.
template <class Observer, class Run, class Vector>
void correct([[maybe_unused]] Observer& observer, [[maybe_unused]] Run& run, [[maybe_unused]] Vector& y) {
    if constexpr (has_member_named<Observer, correct_member> ||
                  correcting_observer<Observer, typename Vector::Scalar, Vector>) {
        static_assert(
            !Run::distributed,
            "problem.add_up: projections and other observers with correct() see the components of one "
            "process alone and cannot be used in a distributed run");
        y = run.y();
        if (correct_state(observer, run.t(), y)) run.replace_state(y);
    }
}

/// Lets the observer save the run, of which take() makes a checkpoint.
template <class Observer, class Take>
void save([[maybe_unused]] Observer& observer, [[maybe_unused]] const Take& take) {
    constexpr bool callable = requires { observer.save(take); };
    static_assert(
        callable || !has_member_named<Observer, save_member>,
        "observer.save must be callable as save(take), take const auto&, a function without arguments that "
        "returns a checkpoint");
    if constexpr (callable) observer.save(take);
}

template <class Observer, class Result>
void conclude([[maybe_unused]] Observer& observer, [[maybe_unused]] Result& result) {
    constexpr bool callable = requires { observer.conclude(result); };
    static_assert(callable || !has_member_named<Observer, conclude_member>,
                  "observer.conclude must be callable as conclude(result) with the result of the run");
    if constexpr (callable) observer.conclude(result);
}

}  // namespace detail

}  // namespace stagecraft
