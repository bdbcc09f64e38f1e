// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/checkpoint.hpp>
#include <stagecraft/run/integrator.hpp>

namespace stagecraft {

/// The checkpoint of a run between two steps. Costs a copy of what it holds.
template <class Method, class Problem, class Vector>
checkpoint<Vector> checkpoint_of(integrator<Method, Problem, Vector>& run) {
    checkpoint<Vector> point{run.t(), run.y(), {}, {}, run.given_options()};
    detail::luggage<checkpoint<Vector>> bag(point);
    run.carry(bag);
    return point;
}

/// Makes `run`, which has been constructed from point.t and point.y, the one of which `point` was taken.
/// Throws std::invalid_argument where the method or the problem is another one, and with options.fixed_step
/// if t1 is another one. Costs a factorisation of implicit methods.
template <class Method, class Problem, class Vector>
void restore(integrator<Method, Problem, Vector>& run, const checkpoint<Vector>& point) {
    detail::luggage<const checkpoint<Vector>> bag(point);
    run.carry(bag);
    bag.finish();
}

}  // namespace stagecraft
