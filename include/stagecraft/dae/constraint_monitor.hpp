// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>

#include <stagecraft/dae/constraints.hpp>

namespace stagecraft {

/// An observer that reports how well a run satisfies the constraints of its problem, hidden ones included, at
/// the accepted steps:
///
///     constraint_monitor<problem_type, Vector> watch(problem);
///     integrate(method, problem, y0, t0, t1, options, watch);
///     watch.largest(0), watch.largest(1)  // the largest |g|, |g_t + g_y f|; watch.time(1): when
///
/// It refers to the problem. Each step costs a Jacobian for index 2 and more for index 3: meant for looking
/// at a run, not for fast ones.
template <class Problem, class Vector>
class constraint_monitor {
  public:
    using scalar = typename Vector::Scalar;

    explicit constraint_monitor(Problem& problem) : problem_(problem) {}

    void start(const scalar& t0, const Vector& y0, const scalar&) {
        system_.emplace(problem_, y0.size());
        worst_ = {};
        (*this)(t0, y0);
    }
    void operator()(const scalar& t, const Vector& y) {
        if (!system_) system_.emplace(problem_, y.size());
        if (system_->count() == 0) return;
        system_->select(t, y, chosen_);
        look(0, t, system_->constraints(t, y));
        look(1, t, system_->hidden(t, y, chosen_));
        look(2, t, system_->twice_hidden(t, y, chosen_));
    }

    /// The largest violation so far, the start included, of the constraints differentiated 0, 1 or 2 times: 0
    /// if there are none, NaN if one was. time() is when it was first met.
    const scalar& largest(int derivatives) const { return worst_.at(derivatives).size; }
    const scalar& time(int derivatives) const { return worst_.at(derivatives).t; }

  private:
    struct worst {
        scalar size{0}, t{0};
    };
    template <class Values>
    void look(int derivatives, const scalar& t, const Values& values) {
        using std::abs;
        for (int i = 0; i < values.size(); ++i)
            if (!(abs(values[i]) <= worst_[derivatives].size))
                worst_[derivatives] = {scalar(abs(values[i])), t};
    }

    Problem& problem_;
    using system = constraint_system<Problem, Vector>;
    std::optional<system> system_;
    typename system::selection chosen_;
    std::array<worst, 3> worst_{};
};

/// A monitor for runs of `problem` with states like y.
template <class Problem, class Derived>
auto monitor_constraints(Problem& problem, const Eigen::MatrixBase<Derived>&) {
    return constraint_monitor<Problem, typename Derived::PlainObject>(problem);
}

}  // namespace stagecraft
