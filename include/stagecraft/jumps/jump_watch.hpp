// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <utility>

namespace stagecraft {

/// Watches a quantity of order h^power that is of the size of the jump where f jumps out of the estimate's
/// sight (blind_spots), in units of the tolerance. It is no estimate of an error, and may be large all the
/// time: a jump shows as ten times what the step before let expect. A smooth solution is told from it when
/// the step is repeated with half of h: there the quantity falls as h^power, and about with h across a jump,
/// which is refused until it has become small. Where the suspicion was false, as no step up to the end of the
/// suspicious one was refused, it takes more to raise the next one, for a while: an explicit method at the
/// border of its stability would raise them all the time.
template <class Scalar>
class jump_watch {
  public:
    /// In units of the tolerance: below it a jump is not worth a second look, as the control keeps errors
    /// within one tolerance of what it cannot see of them, some steps long.
    static Scalar notable() { return Scalar(10); }
    /// Times what the step before let expect: a quantity of order h^3 or more changes by up to eight where a
    /// step is twice as long, within what smooth solutions do in the length of a step.
    static Scalar least_threshold() { return Scalar(10); }

    /// A suspicion is to be tried again with half of the step, a jump with what its size asks for.
    enum class verdict { smooth, suspicion, jump };

    /// Of an attempt that the estimate would accept.
    verdict judge(const Scalar& h, const Scalar& size, int power) {
        using std::abs;
        using std::pow;
        now_ = {abs(h), size};
        if (size <= (suspicious_ ? Scalar(1) : notable())) return verdict::smooth;
        // In the first step nothing was expected: one repetition shows what it is.
        const Scalar ratio = before_.h > Scalar(0) ? Scalar(now_.h / before_.h) : Scalar(0);
        const Scalar smooth = before_.size * (suspicious_ ? Scalar(pow(ratio, Scalar(power + 1) / 2))
                                                          : Scalar(threshold_ * pow(ratio, Scalar(power))));
        if (size <= smooth) return verdict::smooth;
        before_ = now_;
        confirmed_ = suspect_length_ > Scalar(0);
        if (!confirmed_) suspect_length_ = now_.h;
        return std::exchange(suspicious_, true) ? verdict::jump : verdict::suspicion;
    }
    /// The estimate refuses an attempt.
    void refused() { confirmed_ = true; }
    void accepted() {
        suspicious_ = false;
        before_ = now_;
        if (threshold_ > least_threshold()) threshold_ *= Scalar(9) / 10;  // forgotten in some twenty steps
        if (!(suspect_length_ > Scalar(0))) return;
        suspect_length_ -= now_.h;
        if (!(suspect_length_ <= now_.h / 1000)) return;  // but for rounding the end is reached
        suspect_length_ = Scalar(0);
        if (!confirmed_) threshold_ *= least_threshold();
    }

  private:
    struct measured {
        Scalar h{0}, size{0};
    };
    measured before_, now_;
    Scalar threshold_ = least_threshold();  // times what was expected raises suspicion
    Scalar suspect_length_{0};              // to the end of the step that raised it
    bool suspicious_ = false, confirmed_ = false;
};

}  // namespace stagecraft
