// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

namespace stagecraft {

/// Gustafsson's predictive controller (Hairer-Wanner II.IV.8): err_n = C_n h_n^q with C_{n+1}/C_n =
/// C_n/C_{n-1}, never more optimistic than the elementary controller.
template <class Scalar>
class predictive_controller {
  public:
    /// Factor for the step after an accepted one with error `err` (in units of the tolerance).
    Scalar after_accepted(const Scalar& h, const Scalar& err, int q, const Scalar& safety) {
        using std::abs;
        using std::pow;
        const Scalar e = err > floor() ? err : floor();
        const Scalar root = pow(e, Scalar(1) / Scalar(q));
        Scalar factor = safety / root;
        if (has_last_ && last_q_ == q) {
            const Scalar predicted = factor * abs(h / last_h_) * (last_root_ / root);
            if (predicted < factor) factor = predicted;
        }
        has_last_ = true;
        last_h_ = h;
        last_q_ = q;
        last_root_ = root > Scalar(1) / 4 ? root : Scalar(1) / 4;
        return clamp(factor);
    }

    /// Factor for repeating a step whose error was too large.
    Scalar after_rejected(const Scalar& err, int q, const Scalar& safety) const {
        using std::pow;
        return clamp(safety / pow(err, Scalar(1) / Scalar(q)));
    }

    void forget() { has_last_ = false; }

  private:
    static Scalar floor() { return Scalar(1) / 100000000; }
    static Scalar clamp(const Scalar& x) {
        const Scalar low = Scalar(1) / 8, high = Scalar(8);
        return x < low ? low : x > high ? high : x;
    }
    bool has_last_ = false;
    int last_q_ = 0;
    Scalar last_h_{0}, last_root_{0};
};

}  // namespace stagecraft
