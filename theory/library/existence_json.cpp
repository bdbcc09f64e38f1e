// SPDX-License-Identifier: BSL-1.0
// From digits to theorems.
#include "stagecraft/theory/existence/entry_polynomial-inl.hpp"
#include "stagecraft/theory/existence/existence-inl.hpp"
#include "stagecraft/theory/existence/existence_attempt-inl.hpp"
#include "stagecraft/theory/existence/nearby_method-inl.hpp"
#include "stagecraft/theory/existence/order_system-inl.hpp"
#include "stagecraft/theory/existence/sought_method-inl.hpp"
#include "stagecraft/theory/existence/stage_words-inl.hpp"
