// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// Decides whether the solution may be taken as smooth. Only then does an estimate of order q stand for an
/// error of order p + 1 (collocation_step::estimate_ratio). Across a jump of f or of a derivative both are as
/// large as the jump, and the estimate of an embedded pair is only a part of the error
/// (method/blind_spots.hpp). A jump shows as an estimate far beyond the one predicted from the step before, or
/// as one that is still too large after the step has been reduced by the factor that suffices for a smooth
/// solution. From then on the tolerance is applied to what the estimate shows of a jump, until ten steps in a
/// row have met it.
template <class Scalar>
class smoothness {
  public:
    bool doubted() const { return steps_ > 0; }

    /// Takes the estimate of an attempt in units of the tolerance, the one predicted from the step before (0: none), and
    /// whether the same step has just been refused for its error. True if doubt begins with this attempt.
    bool surprised(const Scalar& estimate, const Scalar& expected, bool again) {
        if (doubted()) {
            if (!(estimate < Scalar(1))) steps_ = memory;
            return false;
        }
        if (!(estimate > notable()) && !(again && !(estimate < Scalar(1)))) return false;
        if (!again && (!(expected > Scalar(0)) || estimate <= surprise() * expected)) return false;
        steps_ = memory;
        return true;
    }

    /// A step has been accepted; true if doubt ends with it.
    bool accepted() { return steps_ > 0 && --steps_ == 0; }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(steps_);
    }

  private:
    static constexpr int memory =
        10;  // steps: two or three of growth by the largest factor, and as many more
    /// The predictions of the step control are often wrong by a factor of ten. A factor of a thousand is
    /// three such errors at once, which a smooth solution does not produce.
    static Scalar notable() { return Scalar(10); }
    static Scalar surprise() { return Scalar(1000); }
    int steps_ = 0;
};

}  // namespace stagecraft
