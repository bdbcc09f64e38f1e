// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace stagecraft {

/// What linear algebra costs, in units of about a nanosecond: once per step (a factorisation) and once per
/// iteration (a solve). Counted in operations, not measured, so that what is decided by it is the same on
/// every machine.
template <class Scalar>
struct block_work {
    Scalar step, iteration;
};

/// For one stage, with a dense Jacobian; other structures overload it beside their solvers.
template <class Derived>
auto work_of(const Eigen::MatrixBase<Derived>& J) -> block_work<typename Derived::Scalar> {
    using scalar = typename Derived::Scalar;
    const scalar n = scalar(J.rows());
    return {n * n * n / 3 + 4 * n, n * n};
}

}  // namespace stagecraft
