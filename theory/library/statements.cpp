// SPDX-License-Identifier: BSL-1.0
// Rooted trees, statements and verdicts on them, orders for differential-algebraic equations.
#include "stagecraft/theory/dae/dae_order-inl.hpp"
#include "stagecraft/theory/statements/certainty-inl.hpp"
#include "stagecraft/theory/statements/expression_text-inl.hpp"
#include "stagecraft/theory/statements/verdict-inl.hpp"
#include "stagecraft/theory/trees/coloured_trees-inl.hpp"
#include "stagecraft/theory/trees/effective_order-inl.hpp"
#include "stagecraft/theory/trees/modified_equation-inl.hpp"
#include "stagecraft/theory/trees/rosenbrock_trees-inl.hpp"
#include "stagecraft/theory/trees/tree_text-inl.hpp"
