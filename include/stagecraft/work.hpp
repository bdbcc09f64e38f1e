// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// The kinds of work whose time a problem may ask for (problem/time_split.hpp).
enum class work { f, jacobian, factorisation, solve, run };

}  // namespace stagecraft
