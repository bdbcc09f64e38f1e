// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <stdexcept>
#include <type_traits>

#include <stagecraft/observe/occurrence.hpp>
#include <stagecraft/refuse/detect/named_member.hpp>
#include <stagecraft/refuse/detect/taken_arguments.hpp>

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
///   observer.break_points()
///       Times at which the run is to make steps end and go on afresh (break_points.hpp): a std::vector, say.
///   observer.change(t, y)
///       Called at t0 after start(), and after every step behind all call operators, with the time and the state there (where
///       end_inside() has cut the step, with those). It may change y, or what the problem holds by reference, and
///       then returns true: the run goes on from there as one that begins (observe/at.hpp, event.hpp).
///   observer.changed(t, y)
///       Called after a change with the state behind it.
///   observer.ends_at_start()
///       Called after that at t0. If it returns true the run ends before its first step.
///   observer.end_inside(t, y, h, output)
///       Called after every accepted step before any observer's call operator, with the same arguments. Where the run
///       ends inside this step it returns a pointer to an occurrence with the time and the state of that end, else null.
///       All observers are then called with these in place of t and y, so that none sees what lies beyond the end. (Or it
///       goes on from there, where change() says so.)
///       Its own call operator is not called in a run.
///   observer.save(take)
///       Called after every accepted step, last, unless the run ends inside it; take() makes a checkpoint of the run
///       (checkpoint.hpp).
///   observer.conclude(result)
///       Called last. An observer with end_inside() shortens the run to its end here, and does the same when it is called
///       again; what others have kept beyond result.t they discard.
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
struct end_inside_member {
    int end_inside;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::end_inside;
    };
};
struct change_member {
    int change;
    template <class T>
    static constexpr bool visible_in = requires {
        &T::change;
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

/// True if it looks between the ends of the steps; several do if one of them does (observers.hpp).
template <class Observer, class Vector, class Output>
inline constexpr bool looks_between = asks_for_output<Observer, Vector, Output>;

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

/// The observer may end the run inside a step.
template <class Observer, class Vector, class Output>
concept ending_observer = requires(Observer& observer, const typename Vector::Scalar& t, const Vector& y,
                                   const Output& output) {
    { observer.end_inside(t, y, t, output) } -> std::convertible_to<const occurrence<Vector>*>;
};
/// Where the observer ends the run inside the step, null where it does not.
template <class Observer, class Scalar, class Vector, class Output>
const occurrence<Vector>* end_inside([[maybe_unused]] Observer& observer, [[maybe_unused]] const Scalar& t,
                                     [[maybe_unused]] const Vector& y, [[maybe_unused]] const Scalar& h,
                                     [[maybe_unused]] const Output& output) {
    constexpr bool callable = ending_observer<Observer, Vector, Output>;
    static_assert(
        callable || !has_member_named<Observer, end_inside_member>,
        "observer.end_inside must be callable as end_inside(t, y, h, output) and return a pointer to an "
        "occurrence<Vector>, Vector the type of the state, null where the run goes on");
    if constexpr (callable)
        return observer.end_inside(t, y, h, output);
    else
        return nullptr;
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

/// The same after end_inside() in a run; true means go on.
template <class Observer, class Scalar, class Vector, class Output>
bool tell(Observer& observer, const Scalar& t, const Vector& y, const Scalar& h, const Output& output) {
    if constexpr (requires { observer.tell(t, y, h, output); })
        return observer.tell(t, y, h, output);
    else if constexpr (ending_observer<Observer, Vector, Output>)
        return true;  // has seen the step
    else
        return observe(observer, t, y, h, output);
}

/// The same for a step that the run ends inside, at *end, where that is not null.
template <class Observer, class Scalar, class Vector, class Output>
bool tell_until(const occurrence<Vector>* end, Observer& observer, const Scalar& t, const Vector& y,
                const Scalar& h, const Output& output) {
    if (end == nullptr) return tell(observer, t, y, h, output);
    tell(observer, end->t, end->y, Scalar(end->t - output.t0()), output);
    return false;
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

template <class Observer, class Scalar, class Vector>
concept changing_observer = requires(Observer& observer, const Scalar& t, Vector& y) {
    { observer.change(t, y) } -> std::convertible_to<bool>;
};

/// Lets the observer change y; true if it did.
template <class Observer, class Scalar, class Vector>
bool change_state([[maybe_unused]] Observer& observer, [[maybe_unused]] const Scalar& t,
                  [[maybe_unused]] Vector& y) {
    constexpr bool callable = changing_observer<Observer, Scalar, Vector>;
    static_assert(
        callable || !has_member_named<Observer, change_member>,
        "observer.change must be callable as change(t, y), y a reference to the state, and return "
        "true where the run is to go on from there afresh, else false; times of at<float>(...) in a "
        "run of floats");
    if constexpr (callable)
        return observer.change(t, y);
    else
        return false;
}
/// Tells the observer what y is behind a change.
template <class Observer, class Scalar, class Vector>
void tell_change([[maybe_unused]] Observer& observer, [[maybe_unused]] const Scalar& t,
                 [[maybe_unused]] const Vector& y) {
    if constexpr (requires { observer.changed(t, y); }) observer.changed(t, y);
}
template <class Observer>
bool ends_at_start([[maybe_unused]] const Observer& observer) {
    if constexpr (requires { observer.ends_at_start(); })
        return observer.ends_at_start();
    else
        return false;
}

/// Lets the observer change the state where the run is, or where the step is cut; true if it did. y is scratch.
template <class Observer, class Run, class Vector>
bool change([[maybe_unused]] Observer& observer, [[maybe_unused]] Run& run, [[maybe_unused]] Vector& y,
            [[maybe_unused]] const occurrence<Vector>* cut = nullptr) {
    if constexpr (has_member_named<Observer, change_member> ||
                  changing_observer<Observer, typename Vector::Scalar, Vector>) {
        if (cut) run.restart(cut->t, cut->y);
        const typename Vector::Scalar t = run.t();
        y = run.y();
        const bool inside = run.inside(t, y);
        if (!change_state(observer, t, y)) return false;
        if (inside && !run.inside(t, y))
            throw std::invalid_argument(
                "integrate: a change by at() or event() must not leave problem.domain()");
        run.restart(t, y);
        run.make_consistent();
        tell_change(observer, t, run.y());
        return true;
    } else {
        return false;
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
