// SPDX-License-Identifier: BSL-1.0
// says: A acts from the left
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, A* c) == 1 / 6_q;
#else
constexpr auto e = dot(b, c* A) == 1 / 6_q;
#endif
