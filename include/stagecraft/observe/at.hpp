// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <stagecraft/break_points.hpp>
#include <stagecraft/observe/changed_state.hpp>

namespace stagecraft {

/// What is done at given times; made by at(). See there.
template <class Scalar, class Action>
class timed_action {
  public:
    timed_action(break_times<Scalar> times, Action action)
        : times_(std::move(times)), action_(std::move(action)) {
        times_.validate("at: times", Scalar(0), Scalar(0), false);
    }
    /// The run is to make steps end there.
    const break_times<Scalar>& break_points() const { return times_; }
    const Action& action() const { return action_; }
    template <class Vector>
    void start(const Scalar& t0, const Vector&, const Scalar& t1) {
        times_.validate("at: times", t0, t1, true);
    }
    template <class Vector>
    void operator()(const Scalar&, const Vector&) const {}
    template <class Vector>
    bool change(const Scalar& t, Vector& y) {
        constexpr bool callable = std::is_invocable_v<Action&, const Scalar&, Vector&>;
        static_assert(
            callable,
            "at(times, action): action must be callable as action(t, y), y a reference to the "
            "state, Eigen::Vector3d& or auto&, which it changes (where y0 is a number or an array a "
            "vector all the same: y[0])");
        if (!times_.contains(t)) return false;
        if constexpr (callable) detail::change_by(action_, t, y, "at: the action");
        return true;
    }

  private:
    break_times<Scalar> times_;
    Action action_;
};

/// An observer that changes the state, or parameters that the problem holds by reference, at given times: doses, resets,
/// switches:
///
///     integrate(method, problem, y0, 0, 72, options, at({0.0, 24.0, 48.0}, [](double, Vector3d& y) { y[0] += 100; }));
///     integrate(method, problem, y0, 0, 72, options, observers(at(every(24.0), dose), table));
///
/// It is one run. A step ends exactly at each of the times, which are break points (break_points.hpp), and behind the change
/// the run goes on as one that begins. t0 and t1 may be among the times: the change is then the first, or the last, thing that
/// is done. Where several act at the same time they do so in the order of their arguments in observers().
///
/// At such a time y has two values, and both are kept: csv() writes two rows, the second behind the change; of equal times in
/// output_times the first has the value before and the others that behind it, a time that is given once the one behind;
/// solution is continuous from the right, y(t) being the value behind the change and y.before(t) the one before it.
/// result.y is the state behind all changes. What other observers are called with is the state before; a member
/// changed(t, y) of theirs is called with the one behind (observe/observer.hpp).
///
/// times are strictly increasing or decreasing and lie between t0 and t1: std::invalid_argument names them otherwise. An action
/// that leaves y not finite, or of another size, and one that throws, ends the run in status::function_threw at the state
/// before it. The Scalar is that of the state: at<float>(...) in single precision.
template <class Scalar = double, class Action>
timed_action<Scalar, Action> at(std::type_identity_t<break_times<Scalar>> times, Action action) {
    return {std::move(times), std::move(action)};
}

}  // namespace stagecraft
