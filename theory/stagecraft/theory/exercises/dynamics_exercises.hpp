// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <vector>

#include "stagecraft/theory/dynamics/ghosts.hpp"
#include "stagecraft/theory/dynamics/multistep.hpp"
#include "stagecraft/theory/dynamics/one_sided_lipschitz.hpp"
#include "stagecraft/theory/exercises/exercise.hpp"

// Exercises on what methods do to contractive, dissipative and stable problems.

namespace stagecraft::theory {

/// "fixed points: ...": the claimed ones, increasing, are all that there are, each with its multiplier and with f = 0
/// there or not.
struct claimed_point {
    rational x, multiplier;
    bool equilibrium;
};
certified_statement fixed_points_are(const periodic_points& found, const std::vector<claimed_point>& claimed);

/// Find the ghosts of an explicit method of two stages, b = (0, 1), for x' = a (x - p)(q - x).
exercise find_ghosts(dice& d);

/// The least one-sided Lipschitz constant of a polynomial field.
exercise find_one_sided_constant(dice& d);

/// The least alpha of the dissipativity inequality, and the absorbing balls.
exercise find_absorbing_ball(dice& d);

/// Is the zero solution of x' = B x stable, and which inner product shows it?
exercise solve_lyapunov_equation(dice& d);

/// Order and root condition of a linear multistep method.
exercise check_root_condition(dice& d);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/dynamics_exercises-inl.hpp"
#endif
