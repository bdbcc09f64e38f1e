// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/status.hpp>

namespace stagecraft {

/// What is known of an attempt whose stage equations have not been solved, as plain numbers.
struct unsolved_attempt {
    // Why.
    bool singular = false;         ///< its linear systems are singular, or not finite,
    bool finite_data = true;       ///< although f and J are finite
    bool finite_stages = true;     ///< false: an iterate is not finite, or f is not there,
    bool unsolved_linear = false;  ///< as a linear solver that has failed leaves it
    // What could be changed.
    bool fixed = false;         ///< the step may not be another one
    bool old_jacobian = false;  ///< J is of an earlier step, and not constant
    bool new_border = false;    ///< the first iterate at which f is not finite
    bool noisy_guess = false;   ///< the iteration began at an extrapolated polynomial that may be noisy
};

/// The status of a run that ends with this attempt.
inline status why_unsolved(const unsolved_attempt& a) {
    if (a.singular) return a.finite_data ? status::singular_matrix : status::non_finite;
    if (!a.finite_stages) return a.unsolved_linear ? status::linear_solver_failed : status::non_finite;
    return status::newton_failed;
}

/// What is changed before the step is tried again.
enum class remedy { continued_f, new_jacobian, constant_guess, shorter_step, none };

/// The cheapest change first, one at a time: f continued beyond the border of its domain, a new Jacobian, then another guess, each with the same step; then a shorter
/// step, in which the iteration begins closer to its solution and contracts faster (theta = O(h) where f is smooth).
inline remedy remedy_for(const unsolved_attempt& a) {
    if (a.new_border && !a.unsolved_linear) return remedy::continued_f;
    if (a.old_jacobian) return remedy::new_jacobian;
    if (a.fixed) return remedy::none;
    return a.noisy_guess ? remedy::constant_guess : remedy::shorter_step;
}

}  // namespace stagecraft
