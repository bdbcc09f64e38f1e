// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// What linear algebra costs, in units of about a nanosecond: once per step (a factorisation) and once per
/// iteration (a solve). Counted in operations, not measured, so that what is decided by it is the same on
/// every machine.
template <class Scalar>
struct block_work {
    Scalar step, iteration;
};

/// What the systems of a step cost together: whatever the number of stages, and for each of them.
template <class Scalar>
struct step_work {
    block_work<Scalar> once, per_stage;
};

/// For one stage, by the type of the Jacobian: dense here, other structures beside their solvers.
template <class Matrix>
struct work_of {
    template <class Scalar>
    static block_work<Scalar> estimate(const Matrix& J) {
        const Scalar n = Scalar(J.rows());
        return {n * n * n / 3 + 4 * n, n * n};
    }
};

}  // namespace stagecraft
