// SPDX-License-Identifier: BSL-1.0
#include <stagecraft/bvp/paths/path.hpp>
#include <stagecraft/bvp/periodic_orbit.hpp>

#ifdef STAGECRAFT_BVP_TAKEN
namespace stagecraft::detail {
STAGECRAFT_BVP_ORBIT(template, 5, 2)
STAGECRAFT_BVP_PATHS(template, 2)
}  // namespace stagecraft::detail
#endif
