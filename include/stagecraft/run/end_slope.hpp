// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

namespace stagecraft {

/// f at one end of the step that is being tried, evaluated when it is asked for. What is known at its right
/// end is known at the left end of the next step.
template <class Vector>
class end_slope {
  public:
    using scalar = typename Vector::Scalar;
    explicit end_slope(int n) : f_(n) { f_.setZero(); }

    /// The value that is known, or zeros.
    const Vector& value() const { return f_; }

    /// f(t, y) at the beginning of the step.
    template <class System>
    const Vector& left(System& system, const scalar& t, const Vector& y) {
        if (known_ != end::left) system.evaluate(t, y, f_);
        known_ = end::left;
        return f_;
    }
    /// f(t1, y1) at its end, in place of the value at its beginning.
    template <class System>
    const Vector& right(System& system, const scalar& t1, const Vector& y1) {
        if (known_ != end::right) {
            known_ = end::none;
            system.evaluate(t1, y1, f_);
        }
        known_ = end::right;
        return f_;
    }
    /// f at its end is known to be f1.
    void take_right(const Vector& f1) {
        f_ = f1;
        known_ = end::right;
    }
    /// The step is tried again: its end will be another one.
    void retry() {
        if (known_ == end::right) known_ = end::none;
    }
    /// The step has been accepted.
    void stepped() { known_ = known_ == end::right ? end::left : end::none; }
    /// The state has been replaced.
    void forget() { known_ = end::none; }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(f_, known_);
    }

  private:
    enum class end { none, left, right };
    Vector f_;
    end known_ = end::none;
};

}  // namespace stagecraft
