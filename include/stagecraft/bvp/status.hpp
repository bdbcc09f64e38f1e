// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// Why solve_bvp, periodic_orbit or continuation ended. Only success means a solution within the tolerance
/// that is isolated (M_* regular); everything else keeps the best iterate.
enum class bvp_status {
    success,
    singular,  ///< M is singular to rounding or to the errors of every mesh, and no solution of the guess's size was found
    not_isolated,  ///< solutions exist, but M is singular as far as it is known: result.kernel is its dimension
    equilibrium,      ///< periodic orbits: the orbit found is a point
    multiple_period,  ///< periodic orbits: the period found is a multiple of the smallest one
    ill_conditioned,  ///< rounding errors (of differences, where M is no larger) times the condition number are too large
    newton_failed,  ///< no decrease along the Newton direction; where M is singular there, message says so
    too_many_intervals,  ///< the tolerance asks for more than options.max_intervals
    tolerance_not_met,   ///< the estimated error did not get below the tolerance
    non_finite,          ///< f or r gave NaN or infinity; result.message says where
    size_changed,        ///< f or r resized its output
    function_threw       ///< f or r threw; result.exception holds what
};

/// The status as a word.
constexpr const char* name(bvp_status s) {
    constexpr const char* names[] = {"success",       "singular",           "not_isolated",
                                     "equilibrium",   "multiple_period",    "ill_conditioned",
                                     "newton_failed", "too_many_intervals", "tolerance_not_met",
                                     "non_finite",    "size_changed",       "function_threw"};
    return names[static_cast<int>(s)];
}

}  // namespace stagecraft
