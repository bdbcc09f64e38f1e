// SPDX-License-Identifier: BSL-1.0
// says: every term must be linear in the same
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, u) == dot(b, A* u);
#else
constexpr auto e = dot(b, u) == 1;
#endif
