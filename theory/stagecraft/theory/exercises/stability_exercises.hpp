// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include "stagecraft/theory/dynamics/expansion_witness.hpp"
#include "stagecraft/theory/exercises/exercise.hpp"

// Exercises on stability functions, A-stability and B-stability.

namespace stagecraft::theory {

/// What is the stability function?
exercise find_stability_function(dice& d);

/// Is it A-stable, and why?
exercise is_it_a_stable(dice& d);

/// Is it algebraically stable, and if not, where does it expand?
exercise is_it_b_stable(dice& d);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/stability_exercises-inl.hpp"
#endif
