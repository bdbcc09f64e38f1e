// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

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

/// Calls f(), which solves with one block, and tells the system what a block that iterates says of it. In a distributed
/// run an exception is kept, so that this process takes part in what the next block communicates.
template <class System, class Block, class F>
void solve_together(const System& system, const Block& block, F&& f) {
    if constexpr (requires { system.keep(f); })
        system.keep(f);
    else
        f();
    if constexpr (tells_last_solve<Block> && requires { system.took(block.last_solve()); })
        system.took(block.last_solve());
}

/// What linear solvers that iterate have left of their right-hand sides: `part` at least, 0 where none iterates. A solver
/// that needs many iterations has a preconditioner which does not tell stiff components from others: what is left is of the
/// size asked for where J is large, and may then be much where it is small.
template <class Scalar>
struct left_by_solvers {
    Scalar part{0};
    int iterations = 0;

    template <class Block>
    void add(const Block& block) {
        if constexpr (tells_last_solve<Block> && tells_usual_part<Block>) {
            const int taken = block.last_solve().iterations;
            if (taken == 0) return;
            if (part < Scalar(block.usual_part())) part = Scalar(block.usual_part());
            if (iterations < taken) iterations = taken;
        }
    }
    /// Tells the monitor of an iteration, for a system shift M - J; `asked` is the part that was allowed.
    template <class Monitor>
    void tell(Monitor& monitor, const Scalar& asked, const Scalar& residual, const Scalar& shift) const {
        using std::abs;
        const Scalar left = part < asked ? asked : part;
        monitor.leave(part, iterations > few ? Scalar(left * residual / abs(shift)) : Scalar(0));
    }

  private:
    static constexpr int few = 10;
};

}  // namespace stagecraft
