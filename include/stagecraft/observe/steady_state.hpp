// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

#include <stagecraft/status.hpp>

namespace stagecraft {

/// An observer that ends a run at a steady state; made by steady_state(). See there.
class steady_state_watch {
  public:
    explicit steady_state_watch(double tolerance) : tolerance_(tolerance) {
        if (!(tolerance > 0 && tolerance - tolerance == 0))
            throw std::invalid_argument("steady_state: tolerance must be positive and finite");
    }

    /// True if the last run has reached one.
    bool reached() const { return reached_; }

    template <class Scalar, class Vector>
    void start(const Scalar&, const Vector&, const Scalar&) {
        reached_ = false;
    }
    template <class Scalar, class Vector, class Output>
    requires requires(const Output& output, const Scalar& t) { output.derivative(t); }
    bool operator()(const Scalar& t, const Vector& y, const Scalar&, const Output& output) {
        using std::abs;
        const auto slope = output.derivative(t);
        reached_ = true;
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            const Scalar size = abs(y[i]) > Scalar(1) ? Scalar(abs(y[i])) : Scalar(1);
            reached_ = reached_ && abs(slope[i]) <= Scalar(tolerance_) * size;
        }
        return !reached_;
    }
    template <class Result>
    void conclude(Result& r) {
        if (reached_ && r.status == status::stopped) r.status = status::steady_state;
    }

  private:
    double tolerance_;
    bool reached_ = false;
};

/// An observer that ends a run with status::steady_state at the first step at whose end no component changes by more than
/// `tolerance` in a unit of time, relative to its size where that is above 1: |y_i'| <= tolerance max(1, |y_i|):
///
///     integrate(method, problem, y0, 0, 1e6, options, steady_state(1e-8));
///
/// y' is that of the continuous solution, so that f is not called. Choose the tolerance well above options.rtol divided by
/// the time in which the slowest component changes: what the tolerances of the run leave in y moves as well. An f that depends on t may rest
/// and move again later. std::invalid_argument unless the tolerance is positive and finite.
inline steady_state_watch steady_state(double tolerance) { return steady_state_watch(tolerance); }

}  // namespace stagecraft
