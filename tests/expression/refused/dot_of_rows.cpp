// SPDX-License-Identifier: BSL-1.0
// says: the second argument must be a stage vector
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, c) == 1 / 2_q;
#else
constexpr auto e = dot(b, b) == 1 / 2_q;
#endif
