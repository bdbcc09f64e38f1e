// SPDX-License-Identifier: BSL-1.0
// says: a difference of unlike things
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = A * c == c - one;
#else
constexpr auto e = A * c == c - dot(b, one);
#endif
