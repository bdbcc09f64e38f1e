// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/bvp/solve/solve_functions.hpp>

#ifdef STAGECRAFT_BVP_TAKEN
namespace stagecraft::detail {
STAGECRAFT_BVP_SIZE(template, 2)
}  // namespace stagecraft::detail
#endif
