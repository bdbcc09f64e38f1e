// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include <stagecraft/jacobian/dual_functions.hpp>
#include <stagecraft/jacobian/dual_number.hpp>
#include <stagecraft/jacobian/unconverted.hpp>
#include <stagecraft/method/additive_method.hpp>
#include <stagecraft/method/relaxation_factor.hpp>
#include <stagecraft/step/hermite_output.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft {

/// A tableau, or an additive method, whose steps keep a quantity of the state. Made by relaxation(method, eta) of relaxation.hpp.
template <class Method, class Quantity>
struct relaxed_method {
    using scalar = typename Method::scalar;
    Method method;
    Quantity eta;
};

/// One step of a relaxed method (Ketcheson 2019): y1 = y + gamma d with d = h sum_i b_i k_i, and t1 = t + gamma h, where
/// gamma is the root next to 1 of
///
///     eta(y + gamma d) = eta(y) + gamma h sum_i b_i eta'(Y_i) k_i,
///
/// whose sum is zero for an invariant. Of an additive method b_i k_i is that of both parts together (Ranocha-Sayyari-Dalcin-Parsani-Ketcheson 2020). A
/// step that has to end at its time, at t1 or at a break point, ends there with the same y1: of order p - 1 in that step alone.
/// A step without such a gamma between 1/2 and 3/2 is refused, and a shorter one tried. What rounding leaves of eta is made
/// good in the next step, so that it does not add up.
template <class Method, class Quantity, class Space>
class relaxed_step : public detail::step_for<Method>::template type<Space> {
    using base = typename detail::step_for<Method>::template type<Space>;
    using Scalar = typename Space::scalar;
    using dual = dual_number<Scalar, 1>;
    static constexpr bool in_two_parts = detail::takes_parts<Method>;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;

    relaxed_step(const relaxed_method<Method, Quantity>& m, int n)
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
    void prepare(const System& system, run_demands demands) {
        if constexpr (!System::mass_type::identity || !System::sums_type::complete)
            throw std::invalid_argument(
                "integrate: relaxation(method, eta) serves problems without a mass matrix, in one process");
        if (base::coupled_stages_count() > 1)
            throw std::invalid_argument(
                "integrate: relaxation(method, eta): the stages of method must follow one another (explicit, "
                "diagonally implicit and additive methods); Gauss methods keep quadratic invariants without "
                "it");
        output_wanted_ = demands.output || base::implicit();
        if constexpr (in_two_parts) {
            demands.output = false;  // the slopes at the ends are found here
            keep_slopes();
        }
        base::prepare(system, demands);
    }

    relaxed_step& stages() { return *this; }
    int columns() const { return std::max(base::columns(), int(hermite_output<Space>::cubic_columns)); }
    bool needs_left_value(bool fixed) const { return output_wanted_ || base::needs_left_value(fixed); }
    bool ends_with_value() const { return output_wanted_; }
    void begin(const vector& f0) {
        if (output_wanted_) left_ = f0;
        base::begin(f0);
    }
    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits,
                                 typename output::stage_matrix& Z, long& solves) {
        if constexpr (in_two_parts)
            if (output_wanted_ && !find_left_slope(system, t, y)) return {newton_end::non_finite};
        return base::solve(system, t, y, h, norm, limits, Z, solves);
    }
    void end(const vector& f1) {
        right_ = f1;
        base::end(f1);
    }
    void end_without_value(const Scalar& h, const vector& y, const vector& y1) {
        right_ = (y1 - y) * (Scalar(2) / h) - left_slope();
    }
    template <class System>
    void end_in_parts(const System& system, const Scalar& t1, const Scalar& h, const vector& y,
                      const vector& y1) requires in_two_parts {
        if (!output_wanted_) return;
        this->right_explicit_known_ = base::find_explicit(system, t1, y1, this->right_explicit_);
        if (this->right_explicit_known_)
            right_ += this->right_explicit_;
        else
            end_without_value(h, y, y1);
    }
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) {
        cubic_.cubic(t, y, h, y1, left_slope(), right_, now);
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
        if constexpr (in_two_parts) {
            this->left_explicit_known_ = output_wanted_ && this->right_explicit_known_;
            if (this->left_explicit_known_) this->left_explicit_ = this->right_explicit_;
        }
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

    /// All slopes that the weights ask for are found, also where y1 is the last stage.
    void keep_slopes() {
        for (int j = 0; j < this->count(); ++j) {
            if (this->w_.method.b[j] == Scalar(0)) continue;
            this->needs_explicit_[static_cast<std::size_t>(j)] = true;
        }
    }
    /// y' at the left end. False where it is not finite.
    template <class System>
    bool find_left_slope(const System& system, const Scalar& t, const vector& y) {
        bool& known = this->left_explicit_known_;
        if (!known) known = base::find_explicit(system, t, y, this->left_explicit_);
        this->left_slope_ = left_ + this->left_explicit_;
        return known;
    }
    /// y' at the left end, of both parts; left_ holds that of f, or of f_implicit.
    const vector& left_slope() const {
        if constexpr (in_two_parts)
            return base::left_slope_;
        else
            return left_;
    }
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
            moving_state moving(y.size());
            for (int i = 0; i < this->count(); ++i) {
                if (!weighed(i)) continue;
                find_stage(i);
                for (Eigen::Index k = 0; k < y.size(); ++k) {
                    moving[k] = dual(y[k] + point_[k]);
                    moving[k].derivatives()[0] = change_of(k, i);
                }
                sum += this->h_ * dual(eta_(std::as_const(moving))).derivatives()[0];
            }
        }
        return sum;
    }
    /// Whether y1 takes anything of the slopes of stage i, and component k of what it takes, over h.
    bool weighed(int i) const {
        bool any = !(this->v_.method.b[i] == Scalar(0));
        if constexpr (in_two_parts) any = any || !(this->w_.method.b[i] == Scalar(0));
        return any;
    }
    Scalar change_of(Eigen::Index k, int i) const {
        Scalar change = this->v_.method.b[i] * this->v_.k(k, i);
        if constexpr (in_two_parts) change += this->w_.method.b[i] * this->w_.k(k, i);
        return change;
    }
    /// point_ := Y_i - y.
    void find_stage(int i) {
        const auto& m = this->v_.method;
        this->v_.combine([&](int j) { return m.A(i, j); }, m.stages(), this->h_, point_);
        if constexpr (in_two_parts) {
            const auto& e = this->w_.method;
            this->w_.combine([&](int j) { return e.A(i, j); }, m.stages(), this->h_, this->part_);
            point_ += this->part_;
        }
    }

    Quantity eta_;
    hermite_output<Space> cubic_;
    vector left_, right_, d_, point_;
    Scalar gamma_{1}, eta_before_{0}, eta_after_{0};  // of the run so far, and at the end of the step
    bool output_wanted_ = true, kept_ = false, moved_ = false;
};

namespace detail {

template <class Method, class Quantity>
struct step_for<relaxed_method<Method, Quantity>>
    : step_for<Method> {  // its columns, and whether it takes parts
    static constexpr bool named = true;
    template <class Space>
    using type = relaxed_step<Method, Quantity, Space>;
};

}  // namespace detail

}  // namespace stagecraft
