// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <limits>

#include <stagecraft/options.hpp>
#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// What the iteration of a step by s coupled stages is told, `failures` being how often it has failed in this step.
///
/// A fixed step cannot be repeated with a smaller one, so its iteration is given more room. What it leaves
/// in the stages is magnified by about gamma s^2/h ~ s^3/h, by the slope of the stage polynomial at the
/// left end, in components of index 2 and in the estimate of their errors, twice so with index 3: beyond
/// three stages it has to leave less. Where a free step has been refused, twice and three times as many
/// iterations are allowed: with an approximate Jacobian they may converge steadily at a rate that does not
/// depend on the step. With index k that rate shows after k contractions: an error in a constraint's gradient
/// passes from q to v to lambda, one iteration each. In ordinary differential equations (`ordinary`) it shows after
/// two: where stiff directions turn, an error in one of them passes to other components |h J| times larger, and is
/// gone, or as much smaller, one iteration later. (With a singular M one is waited for: steps that are longer for it
/// leave errors in algebraic components that no next step mends.) For the same reason one fast contraction does not
/// say much: of more than three stages, whose guesses are farther off, it is enough only where the last increment is
/// within two tolerances (ten with fewer), after a failure within one.
template <class Scalar>
newton_limits<Scalar> newton_room(const options<Scalar>& o, int s, int largest_index, bool ordinary,
                                  int failures, bool affine) {
    const bool fixed = o.fixed_step > Scalar(0);
    const Scalar rounding = std::numeric_limits<Scalar>::epsilon() / o.rtol;
    const int most = o.newton_iterations > 0 ? o.newton_iterations
                     : fixed                 ? 50
                                             : usual_iterations(s) * (failures < 2 ? 1 + failures : 3);
    Scalar factor = o.newton_factor;
    if (!(factor > Scalar(0))) {
        factor = Scalar(1) / 50;
        if (!fixed && s > 3)
            for (int k = 3 * (largest_index - 1); k > 0; --k) factor *= Scalar(3) / Scalar(s);
    }
    const int patience = fixed ? 1 : largest_index > 1 ? largest_index + 1 : ordinary ? 2 : 1;
    const Scalar far = s > 1 ? Scalar(1) / o.rtol : Scalar(0);
    return {factor,
            4 * rounding,
            100 * rounding,
            most,
            affine,
            patience,
            ordinary && failures > 0 ? 1 : s > 3 ? 2 : 10,
            far};
}

}  // namespace stagecraft
