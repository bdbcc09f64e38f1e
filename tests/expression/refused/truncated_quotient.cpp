// SPDX-License-Identifier: BSL-1.0
// says: zero_may_be_a_truncated_quotient_write_1_over_15_q_or_0_q
#include <stagecraft/theory/statements/expression.hpp>

using namespace stagecraft::theory::symbols;

#ifdef RIGHT
constexpr auto e = dot(b, c) == 1 / 2_q;
#else
constexpr auto e = dot(b, c) == 1 / 2;
#endif
