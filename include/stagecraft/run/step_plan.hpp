// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include <stagecraft/break_points.hpp>
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
    /// Keeps a pointer to o.break_points.
    step_plan(const Scalar& t0, const Scalar& t1, const options<Scalar>& o)
        : breaks_(&o.break_points),
          last_(t1),
          begin_(t0),
          from_(t0),
          t1_(t1),
          until_(t1),
          direction_(t1 < t0 ? -1 : 1),
          least_(o.min_step),
          most_(o.max_step),
          most_attempts_(o.max_steps) {
        if (o.fixed_step > Scalar(0)) equal_ = plan_equal_steps(t0, t1, largest_ = o.fixed_step);
    }

    /// The run begins, or goes on afresh, at t: where f is to be asked first, which is beyond t if that is a break point.
    Scalar begin(Scalar t) {
        restarts_ = false;
        if (breaks_->empty() && !fixed()) return t;
        return begin_between_breaks(t);
    }
    /// The time of a run whose steps have come to t: the last one before a break point ends there.
    const Scalar& time_at(const Scalar& t) const { return t == t1_ ? until_ : t == from_ ? begin_ : t; }
    /// True if the next step, from t, does not follow from those before.
    bool afresh(const Scalar& t) const { return restarts_ || (t == t1_ && until_ != last_); }
    void go_on_afresh() { restarts_ = true; }
    /// The end of the run, and the number before it.
    const Scalar& last() const { return last_; }
    Scalar before_last() const { return neighbour(last_, begin_); }

    bool fixed() const { return equal_.count > 0; }
    /// The end of the steps up to the next break point.
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

    /// A step from t that ends after `part` of the planned one, unless that ends where a run has to.
    planned_step<Scalar> ended_after(planned_step<Scalar> step, const Scalar& t, const Scalar& part) const {
        if (step.t_next == t1_ || !(part - part == Scalar(0))) return step;
        step.t_next = t + part * step.h;
        step.h = step.t_next - t;
        return step;
    }

    /// What the next step depends on (checkpoint.hpp). A run of equal steps goes on with those it had.
    template <class Bag>
    void carry(Bag& bag) {
        bag.same(fixed(), "kind: options.fixed_step is to be given, or left out, as it was");
        bag(attempts_, restarts_, equal_.count, equal_.first, equal_.last, equal_.h);
        if (fixed() && !restarts_ && equal_.last != t1_) bag.refuse("t1, which equal steps lead to");
    }

  private:
    [[gnu::noinline, gnu::cold]] Scalar begin_between_breaks(Scalar t) {
        begin_ = t;
        until_ = breaks_->next(t, last_);
        from_ = breaks_->contains(t) ? neighbour(t, last_) : t;
        t1_ = breaks_->contains(until_) ? neighbour(until_, t) : until_;
        if (!(direction_ * (t1_ - from_) > Scalar(0))) from_ = t, t1_ = until_;  // no double lies between
        if (fixed()) equal_ = divide_equally(from_, t1_, largest_);
        return from_;
    }
    /// The number next to t on the way to `end`.
    static Scalar neighbour(const Scalar& t, const Scalar& end) {
        using std::abs;
        if constexpr (std::is_floating_point_v<Scalar>) {
            return std::nextafter(t, end);
        } else {
            const Scalar apart = t == Scalar(0) ? std::numeric_limits<Scalar>::min()
                                                : std::numeric_limits<Scalar>::epsilon() * abs(t);
            return t < end ? t + apart : t - apart;
        }
    }
    planned_step<Scalar> next_equal(const Scalar& t, const Scalar& h, long done) const {
        const Scalar to = equal_.end(done + 1);
        const Scalar size = t == equal_.end(done) ? h : Scalar(to - t);  // of relaxed methods
        return {to == t1_ ? not_beyond(t, size, t1_) : size, to};
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

    const break_times<Scalar>* breaks_;
    equal_steps<Scalar> equal_;
    Scalar last_;  // t1 of the run
    Scalar begin_, from_, t1_,
        until_;          // between two break points or ends: their times, and inside where f is asked
    Scalar largest_{0};  // of equal steps
    bool restarts_ = false;
    Scalar direction_, least_, most_;
    long most_attempts_, attempts_ = 0;
};

/// The options of a run with the break points that its problem knows itself.
template <class Problem, class Scalar>
decltype(auto) with_break_points_of([[maybe_unused]] Problem& problem, const options<Scalar>& o) {
    if constexpr (has_break_points<Problem>) {
        options<Scalar> all = o;
        all.break_points.add(break_times<Scalar>(problem.break_points()));
        return all;
    } else {
        return (o);
    }
}

/// The plan of a run, where its arguments are good; std::invalid_argument names the one that is not.
template <class Vector, class Scalar>
step_plan<Scalar> checked_plan(const Vector& y0, const Scalar& t0, const Scalar& t1,
                               const options<Scalar>& o) {
    validate(o, y0.size());
    validate_interval(y0, t0, t1);
    o.break_points.validate("integrate: break_points", t0, t1, false);
    return {t0, t1, o};
}

}  // namespace stagecraft
