// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include <stagecraft/judge/evidence.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/status.hpp>

namespace stagecraft {

/// The attempts at the present step that have been refused: how often, for what, and the status of a run that cannot make
/// the step smaller.
template <class Scalar>
class attempts {
  public:
    const refusals<Scalar>& refused() const { return refused_; }
    status obstacle() const { return obstacle_; }

    /// A step begins. Nothing is written where nothing has been refused: of few unknowns that would take a tenth of a step.
    /// What iterations have come to is kept as long as step after step has one that failed: steps that end just before what
    /// they cannot pass.
    void begin() {
        if (refused_.all + in_a_row_ == 0) return;
        attempts next;
        if (refused_.by_newton > 0) next.in_a_row_ = in_a_row_, next.h_ = h_, next.theta_ = theta_;
        *this = next;
    }
    /// A guard has forbidden an attempt.
    void forbidden(report<Scalar>& counts) {
        obstacle_ = status::step_underflow;
        ++counts.rejected_error;
        ++refused_.all;
    }
    /// An attempt would have ended outside of the domain.
    void outside(report<Scalar>& counts) {
        forbidden(counts);
        obstacle_ = status::outside_domain;
    }
    /// The stage equations of an attempt have not been solved.
    void unsolved(status why, report<Scalar>& counts) {
        obstacle_ = why;
        ++counts.rejected_newton;
        ++refused_.all;
        ++refused_.by_newton;
        if (in_a_row_ < std::numeric_limits<short>::max()) ++in_a_row_;
    }
    /// Attempts that have not been solved, in this step and in those just before that had such as well.
    int in_a_row() const { return in_a_row_; }
    /// Behind unsolved(): a step shorter than h is to be tried, as the iteration of this one contracted by theta.
    void shortened(const Scalar& h, const Scalar& theta) {
        h_ = h;
        theta_ = theta;
    }
    /// How the iteration of a step longer than h did; 0 where there was none.
    Scalar theta_of_longer(const Scalar& h) const {
        using std::abs;
        return abs(h_) > abs(h) ? theta_ : Scalar(0);
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(refused_.all, refused_.by_newton, in_a_row_, h_, theta_);
    }
    /// The error of an attempt at a step of h is not finite.
    void not_finite(status why, report<Scalar>& counts) {
        obstacle_ = why;
        ++counts.rejected_newton;
        ++refused_.all;
    }
    /// It is too large.
    void too_large(const Scalar& h, const Scalar& error, report<Scalar>& counts) {
        obstacle_ = status::step_underflow;
        ++counts.rejected_error;
        ++refused_.all;
        stays_ = refused_.for_error++ > 0 && !refused_.falls(error);
        refused_.h = h;
        refused_.error = error;
    }

    /// A start off the equations without a derivative may be the reason: behind the first failure of the first step, and where
    /// the error does not fall with the step. True once in a step.
    bool may_be_of_the_start(bool first_step) {
        return (first_step || stays_) && !std::exchange(asked_, true);
    }

  private:
    refusals<Scalar> refused_;
    Scalar h_{0}, theta_{0};  // of the attempt behind which a shorter one was tried last
    short in_a_row_ = 0;
    bool stays_ = false, asked_ = false;
    status obstacle_ = status::step_underflow;
};

}  // namespace stagecraft
