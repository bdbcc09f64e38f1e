// SPDX-License-Identifier: BSL-1.0
// says: b is a row: write transposed(A)*b
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = transposed(A) * b == b * (one - c);
#else
constexpr auto e = A * b == b * (one - c);
#endif
