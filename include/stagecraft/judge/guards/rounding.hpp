// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <stagecraft/judge/evidence.hpp>

namespace stagecraft {

/// A singular M with components that behave as of a higher index than index() says, as currents into nodes without
/// capacitance do: they follow from derivatives of other components, so that rounding comes into them, and into the estimate
/// of their error, divided by h. Behind a jump, or at tight tolerances, shorter steps then have larger estimates, and halving
/// ends at the last bit of t. Where steps shrink, an error that is too large is compared with what the estimate changes by
/// where the stages change by their own rounding; if it is no more, the step is accepted: it leaves in y what rounding does,
/// and no shorter step mends the others. The next one is as long as it has to be for rounding to be small. Unless the run has
/// taken steps as long as that, its tolerance is below what rounding leaves, and it fails as before; and no run ends with
/// such a step, nor behind one with an estimate that rounding may have made as small.
///
/// Cost: where M = I the guard is not there; two estimates in attempts refused for their error that are no longer than the
/// step before.
template <class Scalar>
class rounding_guard : public guard_defaults {
  public:
    template <class Step>
    Scalar look(Step& step, const Scalar& error) {
        rounding_ = Scalar(0);
        using std::abs;
        const bool shrinks = step.refused.for_error > 0 || !(abs(step.h) > abs(step.last.h));
        const bool too_large = error >= Scalar(1) && shrinks;
        const bool doubtful = step.ends && seen_;  // where y stands still an estimate is zero
        if (!too_large && !doubtful) return error;
        const Scalar rounding = step.rounding_of_estimate();
        if (doubtful && rounding > several()) return larger(error, rounding);
        if (!too_large || error > several() * rounding) return error;
        at_end_ = at_end_ || (step.ends && rounding > Scalar(1));
        const bool unattainable = at_end_ || several() * rounding * abs(step.h) > step.longest();
        if (rounding > Scalar(1) && unattainable) return error;
        rounding_ = rounding;
        return Scalar(1) / 2;
    }
    /// What it says of the steps to come is rounding as well.
    template <class Step>
    void accepted(Step& step, outlook<Scalar>& seen) {
        if (rounding_ == Scalar(0)) return;
        seen.continues = false;
        seen_ = true;
        step.count_at_rounding();
    }
    /// The next step is as long as rounding needs to be a tenth of the tolerance.
    template <class Step>
    Scalar bound(Step& step, const Scalar& next_h) {
        const Scalar grown = several() * rounding_;
        return grown > Scalar(1) ? Scalar(step.h * grown) : next_h;
    }

    template <class Bag>
    void carry(Bag& bag) {
        bag(at_end_, seen_);
    }

  private:
    /// One rounding of each stage stands for those of all their operations.
    static Scalar several() { return Scalar(10); }
    Scalar rounding_{0};  // of an estimate that is no more, else 0
    bool seen_ = false;   // some step has been accepted for that
    // A step that ends the run has been refused: what is left would become shorter and shorter.
    bool at_end_ = false;
};

}  // namespace stagecraft
