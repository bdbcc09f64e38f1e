// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/judge/evidence.hpp>

namespace stagecraft {

/// First steps across many periods of a solution that starts on the smooth one of a stiff equation: its stages lie on the
/// solution wherever they are, so that the estimate is as small as 1/|J|, but the continuous solution u leaves it in
/// between. (M/(h a) - J)^-1 of the defect of u there tells how far, whatever J is. Later steps start from one that was
/// judged.
///
/// Cost: one evaluation of f and one solve a run.
template <class Scalar>
class first_step_guard : public guard_defaults {
  public:
    template <class Step>
    Scalar look(Step& step, const Scalar& error) {
        if (!step.first || !(error < Scalar(1))) return error;
        const Scalar between = step.error_between_nodes();
        return larger(error, step.ratio < Scalar(1) ? Scalar(between * step.ratio) : between);
    }
};

}  // namespace stagecraft
