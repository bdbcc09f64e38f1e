// SPDX-License-Identifier: BSL-1.0
// says: a factor is exact
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = A * c == 1 / 2_q * pow<2>(c);
#else
constexpr auto e = A * c == 0.5 * pow<2>(c);
#endif
