// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <stagecraft/options.hpp>
#include <stagecraft/run/equal_steps.hpp>
#include <stagecraft/status.hpp>

namespace stagecraft {

/// The step to be tried next, from t to t_next, unless there is none: then `obstacle` says why. h is the
/// difference of the rounded times: at large t a run with other sizes would drift away from its own clock.
template <class Scalar>
struct planned_step {
    Scalar h{0}, t_next{0};
    status obstacle = status::success;
    bool smallest = false;  ///< t resolves no smaller step
};

/// Fits the steps into a run from t0 to t1. Equal steps follow from their number; others are chosen so that
/// the last one ends at t1 and none before it is tiny. Throws what plan_equal_steps() throws.
template <class Scalar>
class step_plan {
  public:
    step_plan(const Scalar& t0, const Scalar& t1, const options<Scalar>& o)
        : t1_(t1),
          direction_(t1 < t0 ? -1 : 1),
          least_(o.min_step),
          most_(o.max_step),
          most_attempts_(o.max_steps) {
        if (o.fixed_step > Scalar(0)) equal_ = plan_equal_steps(t0, t1, o.fixed_step);
    }

    bool fixed() const { return equal_.count > 0; }
    const Scalar& end() const { return t1_; }
    const equal_steps<Scalar>& equal() const { return equal_; }

    /// The first step, of about `size` > 0, within the bounds and with its sign.
    Scalar first(Scalar size, const Scalar& t0) const {
        using std::abs;
        const Scalar span = abs(t1_ - t0);
        if (size > span) size = span;
        if (most_ > Scalar(0) && size > most_) size = most_;
        if (size < least_) size = least_;
        return size * direction_;
    }
    /// h, or the largest step allowed.
    Scalar bounded(const Scalar& h) const {
        using std::abs;
        return most_ > Scalar(0) && abs(h) > most_ ? Scalar(most_ * direction_) : h;
    }

    /// The step to try from t where `h` is wanted, `done` steps have been accepted and the present one has
    /// been tried `failures` times. A step is too small if it is below options.min_step, or after more than 60
    /// failures; one below the resolution of t becomes the smallest that there is.
    planned_step<Scalar> next(const Scalar& t, const Scalar& h, long done, int failures) {
        if (attempts_++ >= most_attempts_) return {h, t, status::too_many_steps};
        return fixed() ? next_equal(t, h, done) : next_free(t, h, failures);
    }

    /// What the next step depends on (checkpoint.hpp). A run of equal steps goes on with those it had.
    template <class Bag>
    void carry(Bag& bag) {
        bag.same(fixed(), "kind: options.fixed_step is to be given, or left out, as it was");
        bag(attempts_, equal_.count, equal_.first, equal_.last, equal_.h);
        if (fixed() && equal_.last != t1_) bag.refuse("t1, which equal steps lead to");
    }

  private:
    planned_step<Scalar> next_equal(const Scalar& t, const Scalar& h, long done) const {
        const Scalar to = equal_.end(done + 1);
        return {to == t1_ ? not_beyond(t, h, t1_) : h, to};
    }
    planned_step<Scalar> next_free(const Scalar& t, const Scalar& wanted, int failures) const {
        using std::abs;
        const Scalar resolved = std::numeric_limits<Scalar>::epsilon() * abs(t), rest = abs(t1_ - t);
        Scalar size = abs(wanted);
        planned_step<Scalar> step{wanted, t1_, status::success, size < 2 * resolved};
        if (step.smallest)
            size = resolved;
        else if (failures > 0 && size < 16 * resolved)
            size -= resolved / 2;  // or rounding might take the step that has failed
        if (size * stretch() >= rest || rest < 2 * resolved) {
            step.h = not_beyond(t, Scalar(t1_ - t), t1_);
        } else {
            if (size * 2 > rest) size = rest / 2;
            step.t_next = t + size * direction_;
            step.h = step.t_next - t;
        }
        if (failures > most_failures || step.t_next == t || abs(wanted) < least_)
            step.obstacle = status::step_underflow;
        return step;
    }
    /// A step may be longer than wanted by so much if it ends at t1 then.
    static Scalar stretch() { return Scalar(1) + Scalar(1) / 100000; }
    static constexpr int most_failures = 60;  // halvings from any step to below the resolution of t

    equal_steps<Scalar> equal_;
    Scalar t1_;
    Scalar direction_, least_, most_;
    long most_attempts_, attempts_ = 0;
};

/// The plan of a run, where its arguments are good; std::invalid_argument names the one that is not.
template <class Vector, class Scalar>
step_plan<Scalar> checked_plan(const Vector& y0, const Scalar& t0, const Scalar& t1,
                               const options<Scalar>& o) {
    validate(o, y0.size());
    validate_interval(y0, t0, t1);
    return {t0, t1, o};
}

}  // namespace stagecraft
