// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include "stagecraft/theory/exercises/exercise.hpp"

// Exercises on order conditions and collocation.

namespace stagecraft::theory {

/// "order p", decided by the conditions of rooted trees up to order p + 1 and by the row sums.
certified_statement order_is(const tableau<rational>& t, int p);

/// "the conditions up to order p that fail are those of the trees `expected`" (in brackets).
certified_statement failing_are(const tableau<rational>& t, int p, std::vector<std::string> expected);

/// "M is regular": a linear system for the missing entries has one solution.
certified_statement one_solution(const tableaux::dense<rational>& M);

/// Two entries, a row of weights, a node or a row of A are missing: which numbers make the order (or stage order)?
exercise missing_entry(dice& d);

/// What is the order of this method?
exercise true_order(dice& d);

/// Which of the order conditions fail in a method that was printed with a mistake?
exercise failing_condition(dice& d);

/// Build the collocation method at given nodes.
exercise build_collocation(dice& d);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/exercises/order_exercises-inl.hpp"
#endif
