// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <stagecraft/sensitivity/crossing.hpp>
#include <stagecraft/sensitivity/located_events.hpp>

namespace stagecraft::detail {

/// What a run forward keeps of an event, or of what is done at a given time, for the way back.
template <class Vector>
struct passage {
    using scalar = typename Vector::Scalar;
    std::vector<int> numbers{};
    bool located = false, terminal = false;
    scalar t{0};
    std::vector<Vector> states{};  ///< before each of the numbers, and behind the last
    // Of an event: where the steps ended, how far the state was moved from there to g = 0, and y' on both sides.
    scalar t_found{0}, moved{0};
    Vector y_found{}, slope{}, slope_behind{};
};

/// Passes what is done at t.
template <class Sides, class Problem, class Vector>
passage<Vector> pass_time(const Sides& sides, Problem& problem, const typename Vector::Scalar& t, Vector& y) {
    passage<Vector> r;
    r.numbers = sides.timed_at(t);
    r.t = t;
    r.states.push_back(y);
    typename Sides::derivatives call;
    for (const int number : r.numbers) {
        sides.take_change(number, t, y, false, call);
        y = call.value();
        r.states.push_back(y);
        sides.change(number, problem);
    }
    return r;
}

/// Passes an event found at (t, y): moves both to g = 0, and y on to behind it. `mean` is the mean slope of g in the step
/// before, `near` becomes how long g takes to zero from what it is behind the event.
template <class Sides, class Problem, class Vector>
passage<Vector> pass_event(const Sides& sides, int number, Problem& problem, typename Vector::Scalar& t,
                           Vector& y, const typename Vector::Scalar& mean, typename Vector::Scalar& near) {
    using std::abs;
    using scalar = typename Vector::Scalar;
    passage<Vector> r;
    r.numbers = {number};
    r.located = true;
    r.terminal = sides.terminal(number);
    r.t_found = t;
    r.y_found = r.slope = r.slope_behind = y;
    typename Sides::derivatives call;
    problem(t, std::as_const(y), r.slope);
    sides.take_event(number, t, y, call);
    const scalar move = -call.value()[0] / call.along(scalar(1), r.slope, -1)[0];
    if (move - move == scalar(0)) {
        r.moved = move;
        y += move * r.slope;
        t += move;
        problem(t, std::as_const(y), r.slope);
        sides.take_event(number, t, y, call);
    }
    sides.rate_of(call, number, t, r.slope, mean);
    r.t = t;
    r.states.push_back(y);
    sides.take_change(number, t, y, true, call);
    y = call.value();
    r.states.push_back(y);
    sides.change(number, problem);
    problem(t, std::as_const(y), r.slope_behind);
    sides.take_event(number, t, y, call);
    near = abs(call.value()[0] / call.along(scalar(1), r.slope_behind, -1)[0]);
    return r;
}

}  // namespace stagecraft::detail
