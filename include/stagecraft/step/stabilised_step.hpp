// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/method/stabilised_method.hpp>
#include <stagecraft/step/method_set.hpp>
#include <stagecraft/step/spectral_radius.hpp>
#include <stagecraft/step/step_between_slopes.hpp>
#include <stagecraft/tableau.hpp>

namespace stagecraft {

/// One step of a stabilised explicit method, in place: whatever the number of stages, five vectors beside y and y1. The
/// spectral radius is asked for in the first step, after a refused one, and after 25 others. The estimate compares y1 with the
/// trapezoidal rule, 4/5 (y - y1) + 2/5 h (f(t, y) + f(t1, y1)) (Sommeijer, Shampine and Verwer 1998), for which
/// f(t1, y1) is evaluated, the next step's first; it is O(h^{order + 1}).
template <class Space>
class stabilised_step : public in_place_step<Space> {
    using Scalar = typename Space::scalar;
    using base = in_place_step<Space>;
    using base::left_, base::right_, base::output_wanted_;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;
    using method_type = stabilised_method<Scalar>;

    stabilised_step(const method_type& method, int n)
        : base(n, true, known_as(method)),
          m_(method),
          rows_(method),
          radius_of_(n),
          y_(n),
          before_(n),
          f_(n) {}

    template <class System>
    void prepare(const System&, const run_demands& demands) {
        base::template refuse_mass<System>("stabilised");
        fixed_ = demands.fixed;
        output_wanted_ = demands.output;
    }

    stabilised_step& stages() { return *this; }
    int count() const { return rows_.stages(); }
    int order() const { return m_.order; }
    int estimate_power() const { return m_.order + 1; }

    bool needs_left_value(bool) const { return !left_known_; }
    static constexpr bool ends_with_value() { return false; }
    void begin(const vector& f0) {
        if (!left_known_) left_ = f0;
    }

    /// The stages. A step that needs more than `most_stages` is diverged.
    template <class System, class Norm>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>&,
                                 typename output::stage_matrix&, long&) {
        using std::abs;
        newton_outcome<Scalar> done;
        if (since_radius_ >= 25 || (tried_ && since_radius_ > 0)) {
            const Scalar radius = radius_of_(system, t, y, left_, norm);
            if (radius - radius == Scalar(0)) radius_ = radius, since_radius_ = 0;
        }
        tried_ = true;
        const int s = m_.stages > 0 ? m_.stages : rows_.stages_for(abs(h) * radius_, most_stages);
        if (s > most_stages) return done;
        rows_.make(s);
        before_ = y;
        y_ = y + (rows_.at(1).rate * h) * left_;
        for (int j = 2; j <= s; ++j) {
            const auto& row = rows_.at(j);
            system(Scalar(t + rows_.at(j - 1).c * h), y_, f_);
            before_ = (Scalar(1) - row.mu - row.nu) * y + row.mu * y_ + row.nu * before_ +
                      (row.rate * h) * f_ + (row.start * h) * left_;
            y_.swap(before_);
        }
        if (!fixed_ || output_wanted_) system(Scalar(t + h), y_, right_);
        if (!fixed_)
            before_ = (Scalar(4) / 5) * (y - y_) + (Scalar(2) / 5 * h) * (left_ + right_);  // the estimate
        done.end = newton_end::converged;
        return done;
    }
    void advance(const vector&, const output&, vector& y1) { y1 = y_; }
    void accepted() {
        left_known_ = !fixed_ || output_wanted_;
        if (left_known_) left_ = right_;
        tried_ = false;
        ++since_radius_;
    }
    void replaced() {
        left_known_ = false;
        since_radius_ = 25;
    }

    template <class System>
    int estimate(const System&, const Scalar&, const vector&, const output&, vector& error) {
        error = before_;
        return 0;
    }

    template <class Bag>
    void carry(Bag& bag) {
        bag(left_, left_known_, radius_, since_radius_);
        bag(radius_of_);
    }

  private:
    static constexpr int most_stages = 20000;  // rounding grows like s^2 eps

    /// Family, stages and damping.
    static tableau<Scalar> known_as(const method_type& m) {
        tableau<Scalar> known;
        known.A.setZero(1, 1);
        known.b.setConstant(1, Scalar(10 * static_cast<int>(m.family) + m.stages));
        known.c.setConstant(1, m.damping);
        return known;
    }

    method_type m_;
    stabilised_recurrence<Scalar> rows_;
    spectral_radius_of<vector> radius_of_;
    vector y_, before_, f_;
    Scalar radius_{0};
    int since_radius_ = 25;
    bool fixed_ = false, left_known_ = false, tried_ = false;
};

namespace detail {

template <class Scalar>
struct step_for<stabilised_method<Scalar>> {
    static constexpr bool named = true;
    static constexpr int columns = 3;
    template <class Space>
    using type = stabilised_step<Space>;
};

}  // namespace detail

}  // namespace stagecraft
