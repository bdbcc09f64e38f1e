// SPDX-License-Identifier: BSL-1.0
// says: the first argument must be a row
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, c) == 1 / 2_q;
#else
constexpr auto e = dot(c, c) == 1 / 2_q;
#endif
