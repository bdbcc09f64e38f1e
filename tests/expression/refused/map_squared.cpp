// SPDX-License-Identifier: BSL-1.0
// says: A*(A*v) for the square of A
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, A*(A* c)) == 1 / 24_q;
#else
constexpr auto e = dot(b, A* A* c) == 1 / 24_q;
#endif
