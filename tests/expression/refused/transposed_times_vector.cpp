// SPDX-License-Identifier: BSL-1.0
// says: transposed(A) acts on rows
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = transposed(A) * b == b * (one - c);
#else
constexpr auto e = transposed(A) * c == one - c;
#endif
