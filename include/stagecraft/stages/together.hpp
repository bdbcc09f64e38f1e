// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/linear/dense_blocks.hpp>

namespace stagecraft {

/// Factors shift M - J, or (re + i im) M - J, in a block. In a distributed run all processes hear of a failure on one,
/// before any of them goes on to the next block.
template <class System, class Block, class... Shift>
bool factor_together(const System& system, Block& block, const Shift&... shift) {
    const auto factor = [&] { return factor_shifted(block, system.mass(), system.jacobian(), shift...); };
    if constexpr (requires { system.succeeds(factor); })
        return system.succeeds(factor);
    else
        return factor();
}

/// Calls f() for one block, which solves with it. In a distributed run an exception is kept, so that this process takes
/// part in what the next block communicates.
template <class System, class F>
void solve_together(const System& system, F&& f) {
    if constexpr (requires { system.keep(f); })
        system.keep(f);
    else
        f();
}

}  // namespace stagecraft
