// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace stagecraft {

/// Whether the solution may be taken as smooth. An estimate of order q stands for an error of order p + 1
/// (collocation_step::estimate_ratio) only where it is: across a jump of f or of a derivative both are of the
/// size of the jump, and that of an embedded pair is a part of the error (jumps/blind_spots.hpp). That shows
/// in an estimate far beyond what the step before let expect, or in one that is still too large when the step
/// has been made smaller as a smooth solution demands. Then what the estimate shows of a jump has to meet the
/// tolerance, until ten steps in a row have.
template <class Scalar>
class smoothness {
  public:
    bool doubted() const { return steps_ > 0; }

    /// Takes the estimate of an attempt (tolerance 1), expected() for the one that was expected (0: none
    /// was), and whether the same step has just been rejected for its error. True if doubt begins with it.
    template <class Expected>
    bool surprised(const Scalar& estimate, Expected&& expected, bool again) {
        if (doubted()) {
            if (!(estimate < Scalar(1))) steps_ = memory;
            return false;
        }
        if (!(estimate > notable()) && !(again && !(estimate < Scalar(1)))) return false;
        if (!again) {
            const Scalar before = expected();
            if (!(before > Scalar(0)) || estimate <= surprise() * before) return false;
        }
        steps_ = memory;
        return true;
    }

    /// A step has been accepted; true if doubt ends with it.
    bool accepted() { return steps_ > 0 && --steps_ == 0; }

  private:
    static constexpr int memory =
        10;  // steps: two or three of growth by the largest factor, and as many more
    /// The step control itself misses by ten often enough; a thousand times what was expected is three steps
    /// of an order of magnitude each, which a smooth solution does not take at once.
    static Scalar notable() { return Scalar(10); }
    static Scalar surprise() { return Scalar(1000); }
    int steps_ = 0;
};

}  // namespace stagecraft
