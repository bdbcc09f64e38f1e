// SPDX-License-Identifier: BSL-1.0
// says: each may occur once in a term
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, u*(A* v)) == dot(b, u) * dot(b, v);
#else
constexpr auto e = dot(b, u*(A* u)) == dot(b, u) * dot(b, u);
#endif
