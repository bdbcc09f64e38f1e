// SPDX-License-Identifier: BSL-1.0
// says: b*A is ambiguous
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = transposed(A) * (b * c) == b * (one - c * c) / 2;
#else
constexpr auto e = (b * c) * A == b * (one - c * c) / 2;
#endif
