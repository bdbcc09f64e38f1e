// SPDX-License-Identifier: BSL-1.0
// says: b*A is ambiguous
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, A* c) == 1 / 6_q;
#else
constexpr auto e = dot(b * A, c) == 1 / 6_q;
#endif
