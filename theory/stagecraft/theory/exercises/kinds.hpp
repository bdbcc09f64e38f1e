// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stagecraft/theory/exercises/dynamics_exercises.hpp"
#include "stagecraft/theory/exercises/exercise.hpp"
#include "stagecraft/theory/exercises/order_exercises.hpp"
#include "stagecraft/theory/exercises/stability_exercises.hpp"

namespace stagecraft::theory {

/// A kind of exercise: its name, what it asks, and how one is made from random choices.
struct exercise_kind {
    std::string name, asks;
    exercise (*make)(dice&);
};

inline const std::vector<exercise_kind>& exercise_kinds() {
    static const std::vector<exercise_kind> all{
        {"missing-entry", "fill the gaps of a tableau so that it has a given order", missing_entry},
        {"order", "find the order of a method", true_order},
        {"failing-condition", "find the order conditions that a misprinted method violates",
         failing_condition},
        {"collocation", "construct the collocation method at given nodes", build_collocation},
        {"stability-function", "compute R(z), R(infinity) and the error constant", find_stability_function},
        {"a-stability", "decide A- and L-stability, with the reason", is_it_a_stable},
        {"b-stability", "decide algebraic stability, or find a problem on which the method expands",
         is_it_b_stable},
        {"ghosts", "find all fixed points of a method, and which are ghosts", find_ghosts},
        {"one-sided-constant", "find the least one-sided Lipschitz constant", find_one_sided_constant},
        {"absorbing-ball", "find the constants of the dissipativity inequality", find_absorbing_ball},
        {"lyapunov", "decide the stability of x' = B x and solve the Lyapunov equation",
         solve_lyapunov_equation},
        {"root-condition", "order and root condition of a multistep method", check_root_condition}};
    return all;
}

/// The exercise of a kind that belongs to a seed: the same on every machine, its solution certified. Throws
/// std::invalid_argument for an unknown kind, and std::logic_error where a statement of the solution was not confirmed.
/// Cost: a millisecond.
exercise make_exercise(const std::string& kind, std::uint64_t seed);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/kinds-inl.hpp"
#endif
