// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/options.hpp>

namespace stagecraft {

/// Oscillating solutions that stiff components follow (a wave beside a fast decay): the estimate changes its sign with the
/// phase of the solution, and where it passes zero the steps would grow far beyond those of the solution. The error then
/// counts as
///     1/4 (last error / last output error) (output error),
/// the output error being that of the continuous solution between the ends, which does not pass zero with it: no more than
/// the output error itself, and nothing where that is below one. A shorter step is expected to have less, as the error at
/// its end falls faster, with h^{2s} beside h^{s+1} (Radau IIA).
///
/// Asked of the first attempt at a step, from three stages on: with two it changes which steps are taken and nothing in
/// their errors. Of 72,000 runs on waves it takes those above 100 tolerances from 253 to 18, for 2 per cent fewer f
/// (examples/campaign). Cost: the norms of two Legendre coefficients a step. With options.continuous, where the output
/// error counts in full, there is nothing to do.
template <class Scalar>
class phase_guard : public guard_defaults {
  public:
    void start(const options<Scalar>& o, const Scalar&) { on_ = !o.continuous; }

    template <class Step>
    Scalar look(Step& step, const Scalar& error) {
        now_ = Scalar(0);
        if (!on_ || !(error < Scalar(1)) || step.index > 1 || step.stages < 3 || !step.knows_output_error())
            return error;
        now_ = step.output_error();
        if (now_ < Scalar(1) || step.refused.all > 0 || step.method != step.last.method ||
            !(last_ > Scalar(0)))
            return error;
        using std::abs;
        using std::pow;
        Scalar expected = step.last.error / last_ / 4;
        const Scalar shorter = abs(step.h / step.last.h);
        if (shorter < Scalar(1))
            expected *= step.stages == 3 ? shorter * shorter : Scalar(pow(shorter, Scalar(step.stages - 1)));
        return larger(error, expected < Scalar(1) ? Scalar(expected * now_) : now_);
    }
    template <class Step>
    void accepted(const Step&, outlook<Scalar>&) {
        last_ = now_;
    }
    template <class Bag>
    void carry(Bag& bag) {
        bag(last_);
    }

  private:
    bool on_ = true;
    Scalar now_{0}, last_{0};  // output errors of this step and of the one before; 0: not asked for
};

/// options.continuous: the error between the ends of the step counts as that at its end does. With a singular M, whose
/// algebraic components have no error at the ends, however far they are from the solution in between, theirs does wherever
/// an observer looks there.
///
/// The last Legendre coefficients of the stages tell it where the solution is smooth. Of kinks, in a forcing that stiff or
/// algebraic components follow, they see some and not others: at one more point, farthest from the nodes, the defect shows
/// what they miss. It is believed where it contradicts them, by ten times.
///
/// Cost, where it is asked for: the norms of two coefficients, one evaluation of f and one solve a step.
template <class Scalar>
class output_guard : public guard_defaults {
  public:
    void start(const options<Scalar>& o, const Scalar&) { on_ = o.continuous; }

    template <class Step>
    Scalar look(Step& step, const Scalar& error) {
        if (!(on_ || step.is_watched_between()) || !(error < Scalar(1)) || !step.knows_output_error())
            return error;
        const Scalar output = on_ ? step.output_error() : step.watched_output_error();
        if (!(output < Scalar(1))) return larger(error, output);
        const Scalar between = step.watched_error_between(on_);
        return larger(error, between > 10 * output ? between : output);
    }

  private:
    bool on_ = false;
};

}  // namespace stagecraft
