// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// Newton's iteration for the stages of a step h from (t, y), begun at the polynomial of the step `before`, or at a
/// constant where there is none. A first increment larger than the solution (limits.far) says that the polynomial does
/// not reach as far as this step, and nothing that follows could be believed: a stiff component may have been led to
/// where f is flat, or to another solution of the stage equations. Then it begins again, at a constant. `limits` is as before when
/// it returns: a copy of it would be made in every step, also of methods that do not iterate.
template <class Step, class System, class Vector, class Norm, class Scalar>
newton_outcome<Scalar> solve_from_guess(Step& method, System& system, const typename Step::output* before,
                                        const Scalar& t, const Vector& y, const Scalar& h, const Norm& norm,
                                        newton_limits<Scalar>& limits, typename Step::output& now,
                                        long& solves) {
    const Scalar far_at = limits.far;
    for (;; before = nullptr) {
        if (before == nullptr) limits.far = Scalar(0);
        method.guess(before, y, h, now);
        const newton_outcome<Scalar> newton =
            method.stages().solve(system, t, y, h, norm, limits, now.increments(), solves);
        const bool far =
            limits.far > Scalar(0) && newton.end == newton_end::diverged && newton.iterations == 1;
        if (!far) {
            limits.far = far_at;
            return newton;
        }
    }
}

}  // namespace stagecraft
