// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <utility>

namespace stagecraft {

/// Watches a quantity of order h^power, in units of the tolerance, that is as large as the jump where f jumps
/// at a blind spot of the estimate. It does not estimate an error and may be large all the time; a suspicion
/// arises when it exceeds ten times the value predicted from the step before. The step is then repeated with
/// h/2. If the solution is smooth, the quantity falls as h^power; across a jump it falls about as h, and the
/// step is refused until the quantity is small. If no step up to the end of the suspicious one was refused,
/// the suspicion was false, and for a while the next one takes more: an explicit method at the border of its
/// stability would raise suspicions all the time.
template <class Scalar>
class jump_watch {
  public:
    /// In units of the tolerance: below it a jump is not worth a second look, as the control keeps errors
    /// within one tolerance of what it cannot see of them, some steps long.
    static Scalar notable() { return Scalar(10); }
    /// As a multiple of the value predicted from the step before. A quantity of order h^3 or more changes by
    /// a factor of up to eight when a step is twice as long, and smooth solutions do that within one step.
    static Scalar least_threshold() { return Scalar(10); }

    /// A suspicion is to be tried again with half of the step, a jump with what its size asks for.
    enum class verdict { smooth, suspicion, jump };

    /// Of an attempt that the estimate would accept.
    verdict judge(const Scalar& h, const Scalar& size, int power) {
        using std::abs;
        using std::pow;
        now_ = {abs(h), size};
        if (size <= (suspicious_ ? Scalar(1) : notable())) return verdict::smooth;
        // In the first step there is no prediction: one repetition shows which of the two it is.
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

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(before_.h, before_.size, now_.h, now_.size, threshold_, suspect_length_, suspicious_, confirmed_);
    }

  private:
    struct measured {
        Scalar h{0}, size{0};
    };
    measured before_, now_;
    Scalar threshold_ = least_threshold();  // multiple of the prediction that raises suspicion
    Scalar suspect_length_{0};              // to the end of the step that raised it
    bool suspicious_ = false, confirmed_ = false;
};

}  // namespace stagecraft
