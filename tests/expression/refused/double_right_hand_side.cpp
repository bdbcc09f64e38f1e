// SPDX-License-Identifier: BSL-1.0
// says: a right-hand side is exact
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, c) == 1 / 2_q;
#else
constexpr auto e = dot(b, c) == 0.5;
#endif
