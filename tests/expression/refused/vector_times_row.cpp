// SPDX-License-Identifier: BSL-1.0
// says: a row comes first
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = transposed(A) * (b * c) == b * (one - c * c) / 2;
#else
constexpr auto e = transposed(A) * (c * b) == b * (one - c * c) / 2;
#endif
