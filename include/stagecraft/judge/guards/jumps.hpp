// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/judge/guards/jump_spacing.hpp>
#include <stagecraft/judge/guards/jump_watch.hpp>
#include <stagecraft/judge/guards/smoothness.hpp>
#include <stagecraft/options.hpp>

namespace stagecraft {

/// Jumps of f and of its derivatives, for which error estimates are not made; options.jumps = false switches it off. It
/// does four things, each only where there is something to gain:
///   - The error may be taken as smaller than its estimate (collocation_step::estimate_ratio), or an embedded
///     pair may show only a part of a jump: `smoothness` says when that must not be relied on.
///   - A pair may show nothing of certain jumps: combinations of the slopes at its blind spots
///     (method/blind_spots.hpp) are then watched by a jump_watch. That costs one combination of the slopes per spot
///     and step, and for each suspicion one step that is taken in two halves.
///   - The jumps that have been found bound the steps that follow (jump_spacing). Before the first one, where a
///     component of y' has been constant, steps at most double: one that a clock switches looks like that, and a
///     step that grows faster may end beyond its first period.
///   - A jump that has been found to the resolution of t is passed.
/// Of 600 runs across one jump it takes those above ten tolerances from 172 to 0, of 600 across the jumps of a clock from
/// 570 to 19, for 2.5 times the evaluations there; where f is smooth nothing changes.
template <class Scalar>
class jump_guard : public guard_defaults {
  public:
    void start(const options<Scalar>& o, const Scalar& t0) {
        on_ = o.jumps;
        least_step_ = worthwhile_steps * o.min_step;
        spacing_ = jump_spacing<Scalar>(t0);
    }

    template <class Step>
    void begin(Step& step) {
        using std::abs;
        worthwhile_ = on_ && abs(step.h) > least_step_ &&
                      abs(step.h) > std::numeric_limits<Scalar>::epsilon() * resolved_steps() * abs(step.t);
        across_ = worthwhile_ ? step.ratio_across_jump() : Scalar(1);
        doubted_ = smooth_.doubted();
        if (doubted_) step.ratio = across_;
    }

    /// Across a jump of f a stiff component ends a step with an error of about what its estimate shows that is filtered
    /// once; filtered twice, it shows about the square. The error decays with the next steps: some tolerances are let pass.
    /// With a singular M nothing is asked: what algebraic components show, filtered once, does not fall with the step.
    template <class Step>
    Scalar estimated(Step& step, const Scalar& error) {
        if (!(step.once > Scalar(0)) || !on_ || step.first || !step.has_identity_mass()) return error;
        const bool jump = doubted_ || (again(step) && step.refused.stays(step.h, step.once, step.power));
        return jump ? larger(error, Scalar(step.once / decaying_share())) : error;
    }

    template <class Step>
    Scalar look(Step& step, const Scalar& error) {
        if (!(error < Scalar(1)) && on_ && !step.first && step.smooth < across_ &&
            smooth_.surprised(error, step.expected, again(step))) {
            step.continues = false;
            step.ratio = across_;
        }
        return worthwhile_ && step.blind_spots() > 0 ? look_at_blind_spots(step, error) : error;
    }

    /// The step is the smallest one, and its error far beyond that predicted from the step before: a jump of f lies within,
    /// and where exactly t does not say. In front of a singularity errors grow gradually, so that they are expected.
    template <class Step>
    bool passes(const Step& step, const Scalar& error) const {
        using std::abs;
        using std::pow;
        if (!on_ || step.last.h == Scalar(0)) return false;
        const Scalar expected = step.last.error * Scalar(pow(abs(step.h / step.last.h), Scalar(step.power)));
        return error > 100 * expected && error < Scalar(1000);
    }

    template <class Step>
    void accepted(const Step& step, outlook<Scalar>& seen) {
        if (step.blind_spots() > 0) watch_.accepted();
        if (smooth_.accepted()) {
            seen.continues = false;
            const Scalar smooth = least_ratio_of_index(step.smooth, step.index);
            if (smooth < Scalar(1)) seen.error *= smooth;
        }
        if (smooth_.doubted()) seen.smooth = false;
    }

    /// No longer than what the jumps seen leave room for; before the first one, if a component of y' has been constant, no
    /// longer than all that the run has seen of f.
    template <class Step>
    Scalar bound(Step& step, const Scalar& next_h) {
        using std::abs;
        const bool beyond = on_ && !spacing_.known() && abs(next_h) > spacing_.since(step.t_next);
        const bool too_long = beyond && step.has_constant_slope();
        const Scalar most = too_long ? spacing_.since(step.t_next) : spacing_.largest(step.t_next);
        return most > Scalar(0) && abs(next_h) > most ? Scalar(next_h < Scalar(0) ? -most : most) : next_h;
    }

    /// An error that does not fall with the step as it does where f is smooth, nearly, is that of a jump.
    template <class Step>
    void refused(const Step& step, const Scalar& error) {
        if (on_ && again(step) && step.refused.stays(step.h, error, step.power))
            spacing_.found(step.t, step.h);
    }

    template <class Bag>
    void carry(Bag& bag) {
        bag(smooth_, watch_, spacing_);
    }

  private:
    /// The same step has been refused for its error before.
    template <class Step>
    static bool again(const Step& step) {
        return step.refused.for_error > 0;
    }
    /// The error, or what replaces it where the slopes show a jump of f at a blind spot of the method.
    template <class Step>
    Scalar look_at_blind_spots(Step& step, const Scalar& error) {
        if (!step.knows_slopes()) return error;
        if (!(error < Scalar(1))) {
            watch_.refused();
            return error;
        }
        const Scalar sign = step.sign_at_blind_spots(jump_watch<Scalar>::notable());
        if (!(sign - sign == Scalar(0))) return error;  // f(t1, y1) need not be finite
        using std::pow;
        switch (watch_.judge(step.h, sign, step.power_at_blind_spots())) {
            case jump_watch<Scalar>::verdict::suspicion:
                return Scalar(pow(halving_error(), Scalar(step.power)));
            case jump_watch<Scalar>::verdict::jump:
                return sign;
            case jump_watch<Scalar>::verdict::smooth:
                break;
        }
        return error;
    }

    /// An error of this to the power of the estimate makes the step control, with its safety factor of 9/10,
    /// take half of the step.
    static Scalar halving_error() { return Scalar(9) / 5; }
    /// A jump is found by making steps smaller: a factor of four over the smallest step allowed leaves two
    /// halvings, and a million times the resolution of t the twenty that tell a jump from a steep slope.
    static constexpr int worthwhile_steps = 4;
    static Scalar resolved_steps() { return Scalar(1000000); }
    /// The tolerances that are let pass of an error that decays.
    static Scalar decaying_share() { return Scalar(10); }

    smoothness<Scalar> smooth_;
    jump_watch<Scalar> watch_;
    jump_spacing<Scalar> spacing_{Scalar(0)};
    Scalar least_step_{0}, across_{1};  // across_: what an estimate of 1 stands for across a jump
    bool on_ = true, worthwhile_ = true, doubted_ = false;  // doubted_: when the attempt began
};

}  // namespace stagecraft
