// SPDX-License-Identifier: BSL-1.0
#pragma once

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
    void begin() {
        if (refused_.all > 0) *this = {};
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
    }
    /// Behind unsolved(): a shorter step is to be tried, as the iteration of this one contracted by theta.
    void shortened(const Scalar& theta) { theta_ = theta; }
    /// How the iteration of a longer step did; 0 where there was none.
    const Scalar& theta_of_longer() const { return theta_; }
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
        ++refused_.for_error;
        refused_.h = h;
        refused_.error = error;
    }

  private:
    refusals<Scalar> refused_;
    Scalar theta_{0};
    status obstacle_ = status::step_underflow;
};

}  // namespace stagecraft
