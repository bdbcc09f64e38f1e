// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <stagecraft/judge/inverse_root.hpp>
#include <stagecraft/options.hpp>

namespace stagecraft {

/// The size of the next step from err_n = C_n h_n^q. Predictive (Gustafsson; Hairer-Wanner II.IV.8):
/// C_{n+1}/C_n = C_n/C_{n-1}, but never more optimistic than the elementary controller. This is good where
/// stiffness lets the step grow by orders of magnitude. Proportional-integral (Hairer-Wanner II.IV.2):
/// h_{n+1}/h_n = err_n^{-0.7/q} err_{n-1}^{0.4/q}, smoother where stability bounds the step of an explicit
/// method.
template <class Scalar>
class step_size_controller {
  public:
    explicit step_size_controller(step_control kind) : kind_(kind) {}

    /// Factor for the step after an accepted one with error `err` (in units of the tolerance).
    Scalar after_accepted(const Scalar& h, const Scalar& err, int q, const Scalar& safety) {
        using std::abs;
        using std::pow;
        const Scalar e = err > floor() ? err : floor();
        const Scalar inverse = inverse_root(e, q);  // of the root of e
        Scalar factor = safety * inverse;
        if (kind_ == step_control::proportional_integral) {
            const Scalar before = has_last_ && last_q_ == q ? last_inverse_ : inverse;
            factor = safety * pow(inverse, Scalar(7) / 10) * pow(before, Scalar(-4) / 10);
        } else if (has_last_ && last_q_ == q) {
            const Scalar predicted = factor * inverse * abs(h / (last_h_ * last_inverse_));
            if (predicted < factor) factor = predicted;
        }
        has_last_ = true;
        last_h_ = h;
        last_q_ = q;
        last_inverse_ = inverse < Scalar(4) ? inverse : Scalar(4);
        return clamp(factor);
    }

    /// Factor for repeating a step whose error was too large.
    Scalar after_rejected(const Scalar& err, int q, const Scalar& safety) const {
        using std::pow;
        return clamp(safety / pow(err, Scalar(1) / Scalar(q)));
    }

    /// The error that a step h was to have by the last one; 0 where there is none to go by.
    Scalar expected(const Scalar& h, int q) const {
        using std::abs;
        using std::pow;
        return has_last_ && last_q_ == q ? Scalar(pow(abs(h / (last_h_ * last_inverse_)), Scalar(q)))
                                         : Scalar(0);
    }

    void forget() { has_last_ = false; }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(has_last_, last_q_, last_h_, last_inverse_);
    }

  private:
    static Scalar floor() { return Scalar(1) / 100000000; }
    static Scalar clamp(const Scalar& x) {
        const Scalar low = Scalar(1) / 8, high = Scalar(8);
        return x < low ? low : x > high ? high : x;
    }
    step_control kind_;
    bool has_last_ = false;
    int last_q_ = 0;
    Scalar last_h_{0}, last_inverse_{0};
};

}  // namespace stagecraft
