// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <stagecraft/judge/guards/jump_spacing.hpp>
#include <stagecraft/judge/guards/jump_watch.hpp>
#include <stagecraft/judge/guards/smoothness.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/tableau/blind_spots.hpp>

namespace stagecraft {

/// All that a run does about jumps of f and of its derivatives, for which error estimates are not made. One
/// object per run, owned by the acceptance of steps; options.jumps = false switches it off. It does four
/// things, each only where there is something to gain:
///   - The error may be taken as smaller than its estimate (collocation_step::estimate_ratio), or an embedded
///     pair may show only a part of a jump: `smoothness` says when that must not be relied on.
///   - A pair may show nothing of certain jumps: combinations of the slopes at its blind spots
///     (find_blind_spots) are then watched by a jump_watch. That costs one combination of the slopes per spot
///     and step, and for each suspicion one step that is taken in two halves.
///   - The jumps that have been found bound the steps that follow (jump_spacing). Before the first one, where a
///     component of y' has been constant, steps at most double: one that a clock switches looks like that, and a
///     step that grows faster may end beyond its first period.
///   - A jump that has been found to the resolution of t is passed: see passes().
/// Nothing is done for fixed steps.
template <class Scalar>
class jump_guard {
  public:
    jump_guard(const options<Scalar>& o, const Scalar& t0)
        : spacing_(t0), on_(o.jumps), least_step_(worthwhile_steps * o.min_step) {}

    /// How the estimate of an attempt is to be read.
    struct reading {
        Scalar ratio;   ///< what an estimate of 1 stands for
        Scalar smooth;  ///< the same if f is smooth
        Scalar across;  ///< and across a jump of f
        bool worthwhile;
    };

    /// Of a step h from t by `method`; an estimate of 1 stands for `smooth` where f is smooth.
    template <class Step>
    reading read(const Step& method, const Scalar& smooth, const Scalar& t, const Scalar& h) const {
        using std::abs;
        const bool worthwhile = on_ && abs(h) > least_step_ &&
                                abs(h) > std::numeric_limits<Scalar>::epsilon() * resolved_steps() * abs(t);
        const Scalar across = worthwhile ? method.jump_ratio(smooth) : Scalar(1);
        return {smooth_.doubted() ? across : smooth, smooth, across, worthwhile};
    }

    /// True if an attempt with error `err` begins the doubt in smoothness; `expected` and `again` as in
    /// smoothness::surprised().
    template <class Expected>
    bool surprised(const reading& r, const Scalar& err, Expected&& expected, bool again) {
        return on_ && r.smooth < r.across && smooth_.surprised(err, expected, again);
    }
    bool doubted() const { return smooth_.doubted(); }

    /// An attempt at a step of size h from t has an error of err >= 1; `again` if the same step has been
    /// refused for its error before. Then it is a jump if the error has not fallen as h^power, nearly, which
    /// it does where f is smooth.
    void refused(const Scalar& t, const Scalar& h, const Scalar& err, int power, bool again) {
        if (on_ && again && stays(h, err, power)) spacing_.found(t, h);
        refused_h_ = h;
        refused_error_ = err;
    }
    /// True if err is smaller than that of the attempt refused last, by a tenth at least.
    bool smaller(const Scalar& err) const { return !(err > refused_error_ * Scalar(9) / Scalar(10)); }
    /// True if the estimate of a step of h, err before it is filtered again, is that of a jump. `again` as above.
    bool across(const Scalar& h, const Scalar& err, int power, bool again) const {
        return on_ && (doubted() || (again && stays(h, err, power)));
    }
    /// True if a step of h from t is longer than all that the run has seen of f, and no jump is known yet.
    bool bold(const Scalar& h, const Scalar& t) const {
        using std::abs;
        return on_ && !spacing_.known() && abs(h) > spacing_.since(t);
    }
    /// h, or the largest step allowed from t: no longer than all that has been seen where that is `too_bold`.
    Scalar bounded(const Scalar& h, const Scalar& t, bool too_bold) const {
        using std::abs;
        const Scalar most = too_bold ? spacing_.since(t) : spacing_.largest(t);
        return most > Scalar(0) && abs(h) > most ? Scalar(h < Scalar(0) ? -most : most) : h;
    }
    /// True if the smallest step that t resolves may be accepted with an error of `err` >= 1, where `expected`
    /// is that predicted from the step before: a jump of f lies within, and where exactly t does not say. In
    /// front of a singularity errors grow gradually, so that they are expected.
    bool passes(const Scalar& err, const Scalar& expected) const {
        return on_ && err > 100 * expected && err < Scalar(1000);
    }

    /// The error of an attempt: `err`, or what replaces it if the slopes show a jump of f at a blind spot of
    /// the method. x is scratch, size(x, false) measures it.
    template <class Step, class System, class Size>
    Scalar judge(Step& method, const System& system, const reading& r, const Scalar& h, const Scalar& err,
                 typename Step::vector& x, long& solves, Size&& size) {
        if constexpr (requires { method.blind(); }) {
            if (!r.worthwhile || method.blind().count() == 0 || !method.knows_slopes()) return err;
            if (!(err < Scalar(1))) {
                watch_.refused();
                return err;
            }
            const Scalar largest = largest_sign(method, system, h, x, solves, size);
            if (!(largest - largest == Scalar(0))) return err;  // f(t1, y1) need not be finite
            using std::pow;
            switch (watch_.judge(h, largest, method.blind().power)) {
                case jump_watch<Scalar>::verdict::suspicion:
                    return pow(halving_error(), method.estimate_power());
                case jump_watch<Scalar>::verdict::jump:
                    return largest;
                case jump_watch<Scalar>::verdict::smooth:
                    break;
            }
        }
        return err;
    }

    /// A step has been accepted: true if the doubt in smoothness ends with it.
    template <class Step>
    bool accepted(const Step& method) {
        if constexpr (requires { method.blind(); })
            if (method.blind().count() > 0) watch_.accepted();
        return smooth_.accepted();
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(smooth_, watch_, spacing_, refused_h_, refused_error_);
    }

  private:
    /// True if the error of a repeated attempt has not fallen with the step as it does where f is smooth.
    bool stays(const Scalar& h, const Scalar& err, int power) const {
        using std::abs;
        using std::pow;
        return err > Scalar(2) && err > refused_error_ * pow(abs(h / refused_h_), Scalar(power + 1) / 2);
    }
    /// The largest value of the combinations at the blind spots. Contributions of stiff components are no
    /// jump, or die out with time: where they matter, the method's own filter removes them, applied twice.
    template <class Step, class System, class Size>
    static Scalar largest_sign(Step& method, const System& system, const Scalar& h, typename Step::vector& x,
                               long& solves, Size&& size) {
        Scalar largest(0);
        for (int g = 0; g < method.blind().count(); ++g) {
            method.weigh_slopes(g, h, x);
            Scalar next = size(x, false);
            for (int k = 0; k < 2 && next > jump_watch<Scalar>::notable() && method.damp(system, x); ++k) {
                ++solves;
                next = size(x, false);
            }
            if (!(next <= largest)) largest = next;
        }
        return largest;
    }

    /// An error of this to the power of the estimate makes the step control, with its safety factor of 9/10,
    /// take half of the step.
    static Scalar halving_error() { return Scalar(9) / 5; }
    /// A jump is found by making steps smaller: a factor of four over the smallest step allowed leaves two
    /// halvings, and a million times the resolution of t the twenty that tell a jump from a steep slope.
    static constexpr int worthwhile_steps = 4;
    static Scalar resolved_steps() { return Scalar(1000000); }

    smoothness<Scalar> smooth_;
    jump_watch<Scalar> watch_;
    jump_spacing<Scalar> spacing_;
    Scalar refused_h_{1}, refused_error_{0};  // of the attempt refused last
    bool on_;
    Scalar least_step_;
};

}  // namespace stagecraft
