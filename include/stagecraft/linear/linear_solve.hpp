// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// How the iteration for a linear system ended.
enum class linear_end {
    solved,             ///< the residual is as small as it was asked to be
    not_finite,         ///< the matrix or the right-hand side is not finite, which is not the solver's fault
    unconverged,        ///< the iterations that are allowed were not enough
    zero_diagonal,      ///< the same, and the incomplete factorisation met zeros on the diagonal
    bad_preconditioner  ///< the preconditioner gave NaN, infinity or zeros
};

/// What a solver that iterates tells of its last solve. Where it has failed the solution is NaN, so that nobody takes it
/// for one, and in a distributed run all processes see it.
struct linear_solve {
    int iterations = 0;
    linear_end end = linear_end::solved;

    bool failed() const { return end != linear_end::solved && end != linear_end::not_finite; }
};

}  // namespace stagecraft
