// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <tuple>
#include <utility>

#include <stagecraft/options.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/equal_steps.hpp>
#include <stagecraft/run/tolerance_norm.hpp>
#include <stagecraft/sensitivity/linear_stages.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/stages/transformed.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft::detail {

/// A second run beside a first, with the same methods and each of its steps in two halves: what the two differ by is about
/// the error of the first. Newton's iterations begin at the solution of the first.
template <class Method, class Problem, class Vector>
class halved_steps {
    using scalar = typename Vector::Scalar;
    using system_type = system<const Problem, Vector>;
    template <int Stages>
    using stages_of = transformed_stages<Vector, Stages, typename system_type::blocks>;
    template <int... Stages>
    static std::tuple<stages_of<Stages>...> make(
        const std::tuple<transformed_tableau<scalar, Stages>...>& methods, int n) {
        return std::apply([n](const auto&... m) { return std::tuple(stages_of<Stages>(m, n)...); }, methods);
    }
    using stages_type = decltype(make(as_tuple(std::declval<const Method&>()), 0));

  public:
    halved_steps(const Method& method, const Problem& problem, const Vector& y0, const options<scalar>& o)
        : system_(problem, y0, report_),
          stages_(make(as_tuple(method), static_cast<int>(y0.size()))),
          options_(o),
          norm_(options_, system_.raised(), y0, system_.sums()),
          y1_(y0),
          f_(y0) {
        system_.take_jacobian();
    }

    /// Goes from y over the step that method number k has made in the first run, which `whole` is; take(output) is called
    /// with both halves. False if Newton's iteration does not converge.
    template <class Output, class Take>
    bool follow(const Output& whole, int k, Vector& y, const Take& take) {
        return visit_at(stages_, k, [&](auto& stages) {
            const scalar h = whole.step() / 2, middle = whole.t0() + h, end = whole.t0() + whole.step();
            // Beyond the end f may be another one.
            return half(stages, whole, whole.t0(), h, y, take) &&
                   half(stages, whole, middle, not_beyond(middle, h, end), y, take);
        });
    }

  private:
    template <class Stages, class Output, class Take>
    bool half(Stages& stages, const Output& whole, const scalar& t, const scalar& h, Vector& y,
              const Take& take) {
        const auto& method = stages.method();
        const int s = method.stages();
        if constexpr (system_type::finite_difference) {
            system_(t, y, f_);
            for (Eigen::Index j = 0; j < y.size(); ++j)
                y1_[j] = absolute_tolerance(options_, j) / options_.rtol / 1000;  // negligible
        }
        system_.evaluate_jacobian(t, y, f_, y1_);
        if (!stages.factor(system_, h)) return false;
        norm_.at(y);
        norm_.over(h);
        Output part = whole;
        const Vector start = whole(t);
        for (int i = 0; i < s; ++i) part.increments().col(i) = whole(t + method.c[i] * h) - start;
        const scalar rounding = std::numeric_limits<scalar>::epsilon() / options_.rtol;
        const newton_limits<scalar> limits{
            scalar(1) / 1000, 4 * rounding, 100 * rounding, 50, false, system_.largest_index() + 1};
        if (stages.solve(system_, t, y, h, norm_, limits, part.increments(), report_.solves).end !=
            newton_end::converged)
            return false;
        part.cover(whole.nodes(), t, h, y);
        const auto d = update_weights(method);
        y1_ = y;
        for (int j = 0; j < s; ++j) y1_ += d[j] * part.increments().col(j);
        take(std::as_const(part));
        y = y1_;
        return y.allFinite();
    }

    report<scalar> report_;
    system_type system_;
    stages_type stages_;
    options<scalar> options_;
    tolerance_norm<Vector, typename system_type::sums_type, system_type::may_be_raised> norm_;
    Vector y1_, f_;
};

}  // namespace stagecraft::detail
