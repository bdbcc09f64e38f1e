// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include <stagecraft/dense_output.hpp>

namespace stagecraft {

/// A continuous solution from the ends of a step: Hermite's cubic where the slopes there are known, of order three, else the
/// quadratic through both ends and the stage nearest the middle.
template <class Space>
class cubic_output {
    using Scalar = typename Space::scalar;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;
    static constexpr int columns(int stages) { return stages > 3 ? stages : 3; }

    cubic_output() : hermite_(3), plain_(3) {
        hermite_.size = 3;
        hermite_.c[0] = Scalar(0), hermite_.c[1] = Scalar(1), hermite_.c[2] = Scalar(1) / 2;
        hermite_.finish();
    }
    /// Makes the nodes of the stages known, those from `first` on.
    template <class Nodes>
    void prepare(const Nodes& c, int first) {
        using std::abs;
        const auto off = [&](int i) { return abs(c[i] - Scalar(1) / 2); };
        for (int i = first; i < c.size(); ++i)
            if (off(i) < Scalar(1) / 2 && (middle_ < 0 || off(i) < off(middle_))) middle_ = i;
        plain_.size = middle_ < 0 ? 1 : 2;
        plain_.c[0] = Scalar(1);
        if (middle_ >= 0) plain_.c[1] = c[middle_];
        plain_.finish();
    }

    /// Fills `now` for the step from (t, y) to y1 with these slopes.
    void by_slopes(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, const vector& left,
                   const vector& right, output& now) const {
        auto& z = now.increments();
        now.cover(hermite_, t, h, y);
        z.col(0) = h * left;
        z.col(1) = y1 - y;
        z.col(2) = (y1 - y) / Scalar(2) + (h / Scalar(8)) * (left - right);
    }
    /// The same with what now.increments() holds of the stages.
    void by_stage(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) const {
        auto& z = now.increments();
        now.cover(plain_, t, h, y);
        if (plain_.size > 1 && middle_ != 1) z.col(1) = z.col(middle_);
        z.col(0) = y1 - y;
    }

  private:
    interpolation_nodes<Scalar, Space::columns> hermite_, plain_;
    int middle_ = -1;
};

}  // namespace stagecraft
