// SPDX-License-Identifier: BSL-1.0
// Exercises with certified solutions.
#include "stagecraft/theory/exercises/dice-inl.hpp"
#include "stagecraft/theory/exercises/document-inl.hpp"
#include "stagecraft/theory/exercises/dynamics_exercises-inl.hpp"
#include "stagecraft/theory/exercises/exercise-inl.hpp"
#include "stagecraft/theory/exercises/html-inl.hpp"
#include "stagecraft/theory/exercises/kinds-inl.hpp"
#include "stagecraft/theory/exercises/methods-inl.hpp"
#include "stagecraft/theory/exercises/order_exercises-inl.hpp"
#include "stagecraft/theory/exercises/sheet-inl.hpp"
#include "stagecraft/theory/exercises/stability_exercises-inl.hpp"
