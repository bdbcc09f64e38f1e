// SPDX-License-Identifier: BSL-1.0
// says: A*u*v is ambiguous
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, c*(A* c)) == 1 / 8_q;
#else
constexpr auto e = dot(b, A* c* c) == 1 / 8_q;
#endif
