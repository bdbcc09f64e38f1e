// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

namespace stagecraft {

/// How often the present step has been refused: at all, for the size of its error, and because its stage equations were
/// not solved.
template <class Scalar>
struct refusals {
    int all = 0, for_error = 0, by_newton = 0;
    Scalar h{1}, error{0};  ///< of the attempt whose error was too large last

    /// True if an error is smaller than the one refused last by a tenth at least.
    bool falls(const Scalar& err) const { return !(err > error * Scalar(9) / Scalar(10)); }
    /// True if the error of an attempt at a step of h has fallen by less than h^{(power+1)/2} since the one refused last,
    /// as it does across a jump of f; where f is smooth it falls by h^power.
    bool stays(const Scalar& new_h, const Scalar& err, int power) const {
        using std::abs;
        using std::pow;
        return err > Scalar(2) && err > error * pow(abs(new_h / h), Scalar(power + 1) / 2);
    }
};

/// The step accepted last; h is zero before the first.
template <class Scalar>
struct accepted_step {
    Scalar h{0}, error{0};
    int method = 0;  ///< its number
};

/// What is known of an attempt whose stage equations are solved, as plain numbers. What has to be measured, run/
/// measured_step.hpp measures when it is asked for it.
template <class Scalar>
struct step_facts {
    Scalar t{0}, h{1}, t_next{0};
    bool first = false;        ///< of the run
    bool ends = false;         ///< at t1 or a break point (told where M may be singular)
    bool smallest = false;     ///< t resolves no smaller step
    bool across_kink = false;  ///< where its estimate, of whatever order, stands for itself
    int method = 0;            ///< its number
    int stages = 1;
    int power = 1;  ///< the estimate is O(h^power)
    int index = 1;  ///< the largest index of a component
    refusals<Scalar> refused;
    accepted_step<Scalar> last;
    int iterations = 0,
        usual_iterations = 7;  ///< of Newton's: made, and that a step of such a method may take
    Scalar theta{0};           ///< their contraction
    Scalar hold{1};            ///< a step that could grow by this at most stays, for the factors there are

    // How the estimate is to be read. The judge sets these first; guards may change them.
    Scalar smooth{1};  ///< what an estimate of 1 stands for where the solution is smooth,
    Scalar ratio{1};   ///< and here
    Scalar share{1};   ///< of the estimate in components of index 2 and 3 that this step has made

    // What is found on the way.
    Scalar once{0};  ///< an estimate that has been filtered twice, filtered once
    Scalar expected{
        0};  ///< where the error is 1 or more: that predicted from the step before, 0 if there is none
    bool continues =
        true;  ///< false: a guard has found that the estimate is to be read in another way from here on
};

/// What an estimate of 1 stands for where the solution is smooth, of an error that any component may have. Of components of
/// index 2 and 3 the errors are of the order of the estimate itself, not of that of y, so that the ratio of the two orders
/// says nothing about them. An estimate of 1 there counts as an error of a quarter: |h| e_z then stays within about ten
/// tolerances. With 1 it would stay within three, for a third more steps.
template <class Scalar>
Scalar least_ratio_of_index(const Scalar& ratio, int index) {
    const Scalar raised = Scalar(1) / 4;
    return index > 1 && ratio < raised ? raised : ratio;
}

/// What an accepted step tells of those to come.
template <class Scalar>
struct outlook {
    Scalar error;           ///< by which the next step is chosen
    bool continues = true;  ///< the trend of the steps before goes on
    bool smooth = true;     ///< the solution is smooth, so that methods of other order can be compared
};

/// What the judge says of an attempt.
template <class Scalar>
struct verdict {
    bool accepted;
    Scalar error;   ///< of the attempt, 1 being the tolerance; may be NaN where it is refused
    Scalar next_h;  ///< the step to try next, from the end of an accepted step, or again
};

/// The larger of two errors, NaN being larger than any.
template <class Scalar>
Scalar larger(const Scalar& err, const Scalar& other) {
    return other <= err || !(err == err) ? err : other;
}

/// What a guard need not say. A guard is a class of its own for one class of problems that the error estimate does not
/// judge rightly. It derives from this and hides the members that it needs; all are asked in this order:
struct guard_defaults {
    /// A run begins at t0. Once.
    template <class Options, class Scalar>
    void start(const Options&, const Scalar& /*t0*/) {}
    /// The Jacobian is new.
    void linearised() {}
    /// The matrices of a step are factored: true if it is not to be tried (run/linearisation.hpp: factored_step).
    template <class Factored>
    bool forbids(const Factored&) {
        return false;
    }
    /// The stage equations are solved, nothing is measured yet: the place to change step.ratio and step.share.
    template <class Step>
    void begin(Step&) {}
    /// An estimate has been measured, for the first time or once more filtered: the error to go on with.
    template <class Step, class Scalar>
    Scalar estimated(Step&, const Scalar& error) {
        return error;
    }
    /// All estimates have been measured: the error to go on with. Numbers that this guard needs are measured here. With
    /// step.continues = false the estimate is sized again, by the step.ratio that the guard has set.
    template <class Step, class Scalar>
    Scalar look(Step&, const Scalar& error) {
        return error;
    }
    /// True if an error that is too large is accepted in the smallest step that t resolves.
    template <class Step, class Scalar>
    bool passes(const Step&, const Scalar& /*error*/) const {
        return false;
    }
    /// The attempt is accepted: what follows from it for the next steps may be changed.
    template <class Step, class Scalar>
    void accepted(const Step&, outlook<Scalar>&) {}
    /// The step that would follow, with its sign: it, or a shorter one.
    template <class Step, class Scalar>
    Scalar bound(Step&, const Scalar& next_h) {
        return next_h;
    }
    /// The attempt is refused for its error, which is finite. Not called in the first step, whose size was a guess.
    template <class Step, class Scalar>
    void refused(const Step&, const Scalar& /*error*/) {}
    /// bag(...) with what is kept for the next step (checkpoint.hpp).
    template <class Bag>
    void carry(Bag&) {}
};

}  // namespace stagecraft
