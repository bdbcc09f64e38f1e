// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <stagecraft/jacobian/dual_functions.hpp>
#include <stagecraft/jacobian/dual_number.hpp>
#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/method/relaxation_factor.hpp>
#include <stagecraft/step/hermite_output.hpp>
#include <stagecraft/step/method_set.hpp>
#include <stagecraft/step/tableau_step.hpp>

namespace stagecraft {

/// A tableau whose steps keep a quantity of the state. Made by relaxation(method, eta) of relaxation.hpp.
template <class Tableau, class Quantity>
struct relaxed_method {
    using scalar = typename Tableau::scalar;
    Tableau method;
    Quantity eta;
};

/// One step of a relaxed method (Ketcheson 2019): y1 = y + gamma d with d = h sum_i b_i k_i, and t1 = t + gamma h, where
/// gamma is the root next to 1 of
///
///     eta(y + gamma d) = eta(y) + gamma h sum_i b_i eta'(Y_i) k_i,
///
/// whose sum is zero for an invariant. A step that has to end at its time, at t1 or at a break point, ends there with the
/// same y1: of order p - 1 in that step alone. A step without such a gamma between 1/2 and 3/2 is refused, and a shorter one
/// tried. What rounding leaves of eta is made good in the next step, so that it does not add up.
template <class Tableau, class Quantity, class Space>
class relaxed_step : public tableau_step<static_cast<int>(Tableau::vector::RowsAtCompileTime), Space> {
    using base = tableau_step<static_cast<int>(Tableau::vector::RowsAtCompileTime), Space>;
    using Scalar = typename Space::scalar;
    using dual = dual_number<Scalar, 1>;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;

    relaxed_step(const relaxed_method<Tableau, Quantity>& m, int n)
        : base(m.method, n),
          eta_(m.eta),
          cubic_(hermite_output<Space>::cubic_columns),
          left_(n),
          right_(n),
          d_(n),
          point_(n) {
        left_.setZero();
    }

    template <class System>
    void prepare(const System& system, const run_demands& demands) {
        if constexpr (!System::mass_type::identity || !System::sums_type::complete)
            throw std::invalid_argument(
                "integrate: relaxation(method, eta) serves y' = f(t, y), without a mass matrix, in one "
                "process");
        if (base::coupled_stages_count() > 1)
            throw std::invalid_argument(
                "integrate: relaxation(method, eta): the stages of method must follow one another (explicit "
                "or "
                "diagonally implicit methods); Gauss methods keep quadratic invariants without it");
        base::prepare(system, demands);
        output_wanted_ = demands.output || base::implicit();
    }

    int columns() const { return std::max(base::columns(), int(hermite_output<Space>::cubic_columns)); }
    bool needs_left_value(bool fixed) const { return output_wanted_ || base::needs_left_value(fixed); }
    bool ends_with_value() const { return output_wanted_; }
    void begin(const vector& f0) {
        if (output_wanted_) left_ = f0;
        base::begin(f0);
    }
    void end(const vector& f1) {
        right_ = f1;
        base::end(f1);
    }
    void end_without_value(const Scalar& h, const vector& y, const vector& y1) {
        right_ = (y1 - y) * (Scalar(2) / h) - left_;
    }
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) {
        cubic_.cubic(t, y, h, y1, left_, right_, now);
    }

    /// y1 := the relaxed state; NaN where there is none.
    void advance(const vector& y, const output& now, vector& y1) {
        base::advance(y, now, y1);
        d_ = y1 - y;
        if (!kept_) eta_before_ = value_at_start(y);
        const Scalar made = production(y), from = eta_before_;
        using std::abs;
        gamma_ = relaxation_factor(Scalar(abs(from) + abs(from + made)), [&](const Scalar& gamma) {
            point_ = y + gamma * d_;
            return Scalar(Scalar(eta_(point_)) - from - gamma * made);
        });
        y1 = y + gamma_ * d_;
        eta_after_ = from + gamma_ * made;
    }
    /// The part of the planned step after which it ends.
    const Scalar& part_taken() const { return gamma_; }

    void accepted() {
        base::accepted();
        base::replaced();  // the slope of the last stage is not that of y1
        eta_before_ = eta_after_;
        kept_ = !moved_;
        moved_ = false;
    }
    void replaced() {
        base::replaced();
        kept_ = false;
        moved_ = true;
    }
    template <class Bag>
    void carry(Bag& bag) {
        base::carry(bag);
        bag(eta_before_, kept_);
    }

  private:
    using moving_state = Eigen::Matrix<dual, vector::RowsAtCompileTime, 1>;
    static constexpr bool generic = detail::callable_unconverted<const Quantity, const moving_state&>;

    /// A run begins, or goes on afresh, at y.
    [[gnu::cold]] Scalar value_at_start(const vector& y) {
        moved_ = false;
        const Scalar value(eta_(y));
        if (!(value - value == Scalar(0)))
            throw bad_problem("integrate: relaxation(method, eta): eta must be finite at y0");
        return value;
    }
    /// h sum_i b_i eta'(Y_i) k_i; zero where eta takes numbers alone, which then is an invariant.
    Scalar production([[maybe_unused]] const vector& y) {
        Scalar sum(0);
        if constexpr (generic) {
            const auto& m = this->v_.method;
            moving_state moving(y.size());
            for (int i = 0; i < m.stages(); ++i) {
                if (m.b[i] == Scalar(0)) continue;
                this->v_.combine([&](int j) { return m.A(i, j); }, m.stages(), this->h_, point_);
                for (Eigen::Index k = 0; k < y.size(); ++k) {
                    moving[k] = dual(y[k] + point_[k]);
                    moving[k].derivatives()[0] = this->v_.k(k, i);
                }
                sum += this->h_ * m.b[i] * dual(eta_(std::as_const(moving))).derivatives()[0];
            }
        }
        return sum;
    }

    Quantity eta_;
    hermite_output<Space> cubic_;
    vector left_, right_, d_, point_;
    Scalar gamma_{1}, eta_before_{0}, eta_after_{0};  // of the run so far, and at the end of the step
    bool output_wanted_ = true, kept_ = false, moved_ = false;
};

namespace detail {

template <class Tableau, class Quantity>
struct step_for<relaxed_method<Tableau, Quantity>> {
    static constexpr bool named = true;
    static constexpr int columns = step_for<Tableau>::columns;
    template <class Space>
    using type = relaxed_step<Tableau, Quantity, Space>;
};

}  // namespace detail

}  // namespace stagecraft
