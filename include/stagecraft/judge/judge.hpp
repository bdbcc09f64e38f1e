// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/judge/order.hpp>
#include <stagecraft/judge/step_size.hpp>
#include <stagecraft/options.hpp>

namespace stagecraft {

/// Decides about the steps of a run: takes an attempt whose stage equations are solved (step_facts and what can be measured
/// of it, run/measured_step.hpp) and says whether it is accepted and which step comes next; with several methods also
/// which of them. Errors have tolerance 1. Guards is a std::tuple (judge/evidence.hpp); every guard sees the error that
/// those before it leave.
template <class Scalar, int Methods, class Guards>
class judge {
  public:
    static constexpr bool several_methods = (Methods > 1);

    judge(const options<Scalar>& o, const Scalar& t0, Guards guards)
        : controller_(o.control), guards_(std::move(guards)) {
        each([&](auto& guard) { guard.start(o, t0); });
    }
    /// A run goes on at t0 as one that begins, with new guards.
    void start(const options<Scalar>& o, const Scalar& t0, Guards guards) {
        guards_ = std::move(guards);
        controller_.forget();
        order_.start();
        last_ = {};
        each([&](auto& guard) { guard.start(o, t0); });
    }

    /// Number of the method in use.
    int method() const { return order_.current(); }
    /// The step accepted last.
    const accepted_step<Scalar>& last() const { return last_; }
    /// What an estimate of 1 by method k stands for where the solution is smooth.
    const Scalar& smooth_ratio(int k) const { return ratio_[static_cast<std::size_t>(k)]; }
    /// Makes method number k known.
    void prepare(int k, const Scalar& smooth_ratio) { ratio_[static_cast<std::size_t>(k)] = smooth_ratio; }
    void prepare(int k, const order_candidate<Scalar>& c, const Scalar& rtol) requires(Methods > 1) {
        order_.prepare(k, c, rtol);
    }

    /// The Jacobian is new.
    void linearised() {
        each([](auto& guard) { guard.linearised(); });
    }
    /// True if a guard forbids to try the step whose matrices have been factored.
    template <class Factored>
    bool forbids(const Factored& step) {
        bool any = false;
        each([&](auto& guard) { any = any || guard.forbids(step); });
        return any;
    }
    /// Newton's iteration has failed though the Jacobian is new; `again` in this step: another method is to try.
    void unsolved(bool again) {
        if constexpr (Methods > 1) order_.newton_failed(again);
    }

    template <class Step>
    verdict<Scalar> operator()(Step& step) {
        step.smooth = step.ratio = step.across_kink ? Scalar(1) : smooth_ratio(step.method);
        step.last = last_;
        const Scalar error = error_of(step);
        if (error < Scalar(1) || (step.smallest && passes(step, error))) return accept(step, error);
        return refuse(step, error);
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(controller_, order_, last_.h, last_.error, last_.method);
        each([&](auto& guard) { bag(guard); });
    }

  private:
    template <class F>
    void each(F&& f) {
        std::apply([&](auto&... guard) { (f(guard), ...); }, guards_);
    }

    /// The error of an attempt. An estimate that is too large is filtered once more in the first step and after a refusal
    /// (Hairer-Wanner II.IV.8, (8.20)); one at the right end is made only where the left one would accept.
    template <class Step>
    [[gnu::always_inline]] Scalar error_of(Step& step) {
        each([&](auto& guard) { guard.begin(step); });
        Scalar error = estimated(step, step.estimate());
        if (error >= Scalar(1) && (step.first || step.refused.all > 0))
            error = estimated(step, step.estimate_again());
        if (error < Scalar(1)) error = larger(error, step.estimate_right());
        if (!(error < Scalar(1))) step.expected = controller_.expected(step.h, step.power);
        each([&](auto& guard) { error = guard.look(step, error); });
        if (!step.continues) {
            controller_.forget();
            error = larger(error, estimated(step, step.size()));
        }
        return error < Scalar(1) ? larger(error, step.further()) : error;
    }
    template <class Step>
    [[gnu::always_inline]] Scalar estimated(Step& step, Scalar error) {
        each([&](auto& guard) { error = guard.estimated(step, error); });
        return error;
    }
    template <class Step>
    bool passes(const Step& step, const Scalar& error) {
        bool any = false;
        each([&](auto& guard) { any = any || guard.passes(step, error); });
        return any;
    }

    template <class Step>
    [[gnu::always_inline]] verdict<Scalar> accept(Step& step, const Scalar& error) {
        outlook<Scalar> seen{error};
        each([&](auto& guard) { guard.accepted(step, seen); });
        last_ = {step.h, error, step.method};
        if (!seen.continues) controller_.forget();
        Scalar next = step.h * next_factor(step, seen);
        each([&](auto& guard) { next = guard.bound(step, next); });
        return {true, error, next};
    }
    /// The next step as a multiple of this one. The more iterations this one took, the more careful.
    template <class Step>
    [[gnu::always_inline]] Scalar next_factor(Step& step, const outlook<Scalar>& seen) {
        const int twice = 2 * step.usual_iterations;
        const Scalar safety = usual_safety() * Scalar(twice + 1) / Scalar(twice + step.iterations);
        Scalar factor = controller_.after_accepted(step.h, seen.error, step.power, safety), hold = step.hold;
        if (step.refused.all > 0 && factor > Scalar(1)) factor = Scalar(1);
        if constexpr (Methods > 1) {
            order_.accepted();
            if (order_.wants_evidence() && step.refused.all == 0 && seen.smooth) {
                const Scalar change = order_.decide(
                    {step.h, seen.error, step.decay(), step.theta, step.iterations, step.linear_work()});
                if (change > Scalar(0)) {
                    factor = change;
                    if (hold > Scalar(6) / 5) hold = Scalar(6) / 5;  // the factors were another method's
                    controller_.forget();
                }
            }
        }
        return factor >= Scalar(1) && factor <= hold ? Scalar(1) : factor;
    }

    /// The size of a first step was a guess. An error that does not fall with the step (a stiff component that the step before
    /// left beside the smooth solution shows it, until h |J| is about one) makes it smaller by the largest factor; but
    /// not with components of index 2 and 3, whose estimates contain what earlier steps left of them anyway.
    template <class Step>
    verdict<Scalar> refuse(Step& step, const Scalar& error) {
        if (!(error - error == Scalar(0))) return {false, error, step.h / 8};
        if (step.first) return {false, error, step.h / 10};
        each([&](auto& guard) { guard.refused(step, error); });
        const bool stays =
            step.share == Scalar(1) && step.refused.for_error > 0 && !step.refused.falls(error);
        const Scalar factor = controller_.after_rejected(error, step.power, usual_safety());
        return {false, error, stays ? Scalar(step.h / 8) : Scalar(step.h * factor)};
    }

    static Scalar usual_safety() { return Scalar(9) / Scalar(10); }

    std::array<Scalar, static_cast<std::size_t>(Methods)> ratio_{};
    step_size_controller<Scalar> controller_;
    order_controller<Scalar, Methods> order_{};
    Guards guards_;
    accepted_step<Scalar> last_{};
};

}  // namespace stagecraft
