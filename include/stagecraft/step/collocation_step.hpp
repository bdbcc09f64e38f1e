// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>

#include <stagecraft/dense_output.hpp>
#include <stagecraft/linear/mass_kernel.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/method/collocation_functionals.hpp>
#include <stagecraft/method/remembered.hpp>
#include <stagecraft/stages/transformed.hpp>
#include <stagecraft/step/collocation_facts.hpp>
#include <stagecraft/step/one_step_method.hpp>
#include <stagecraft/step/stage_extrapolation.hpp>

namespace stagecraft {

/// One step of a method with regular A and distinct nodes: first guess, stage equations, update, error
/// estimate.
///
/// Error estimate. For c_1 > 0 (Radau IIA, Gauss) it is the defect of the collocation polynomial u at the
/// left end,
///     err = (gamma/h M - J)^-1 (f(t, y) - M u'(t)),
/// which equals the embedded formula of order s with weight h/gamma on f(t, y) (Hairer-Wanner II.IV.8,
/// (8.19)): f(t, y) - u'(t) is the error of interpolating u' at c, extrapolated to 0. gamma is the real
/// eigenvalue of A^-1; where there is none (even s) the modulus of the complex block of smallest beta takes
/// its place, which costs no factorisation and vanishes for no J. For c_1 = 0 (Lobatto IIIC, Radau IA) it is
/// the jump z_1 = Y_1 - y of the stage polynomial, O(h^s), damped at infinity by the method itself.
template <int Stages, class Space>
class collocation_step : public step_defaults<Space> {
    using Scalar = typename Space::scalar;
    using weights = Eigen::Matrix<Scalar, Stages, 1>;
    using facts = collocation_facts<Scalar, Stages, Space::columns>;

  public:
    using vector = typename Space::vector;
    using output = typename Space::output;
    using method_type = transformed_tableau<Scalar, Stages>;

    collocation_step(const method_type& method, int n)
        : stages_(method, n),
          known_(remembered(method, [&] { return facts::of(method); })),
          extrapolation_(Space::columns < 0 ? method.stages() : Space::columns, method.stages()),
          scratch_(n),
          second_(n),
          rest_(n) {}

    transformed_stages<vector, Stages, typename Space::blocks>& stages() { return stages_; }
    const method_type& method() const { return stages_.method(); }
    int count() const { return stages_.stages(); }
    int order() const { return known_.order; }
    /// The estimate is O(h^q) with this q.
    int estimate_power() const { return known_.jump ? count() : count() + 1; }
    /// What an estimate of 1 stands for, tolerances being 1: the estimate is O(h^q), the error O(h^{p+1}),
    /// and an estimate of 0.1 rtol^{q/(p+1)} stands for an error of about rtol (Hairer-Wanner 1999, "Stiff
    /// differential equations solved by Radau methods").
    Scalar estimate_ratio(const Scalar& rtol) const {
        using std::pow;
        const Scalar e = Scalar(estimate_power()) / Scalar(order() + 1);
        return e < Scalar(1) ? Scalar(10 * pow(rtol, Scalar(1) - e)) : Scalar(10);
    }
    /// The same across a jump of f: the estimate stands for itself.
    Scalar jump_ratio(const Scalar& smooth) const { return smooth < Scalar(1) ? Scalar(1) : smooth; }
    /// True if the step uses f at its left end: for the estimate.
    bool needs_left_value(bool fixed) const { return !fixed && !known_.jump; }

    static constexpr bool implicit() { return true; }
    int coupled_stages_count() const { return count(); }
    int columns() const { return count(); }
    /// Serves every run.
    template <class System>
    [[gnu::cold]] void prepare(const System& system, const run_demands& demands) {
        extrapolation_.prepare(known_.nodes);
        if (demands.fixed) return;
        if constexpr (!System::mass_type::identity && has_entries<typename System::mass_type> &&
                      System::sums_type::complete)
            if (!forgets() && !known_.stiffly_accurate)
                algebraic_ = std::make_unique<mass_kernel<Scalar>>(system.mass(), system.size());
        top_ = remembered(stages_.method(), [&] {
            return highest_legendre_coefficients<Scalar>(known_.nodes.c, known_.nodes.size);
        });
    }

    /// First guess: the polynomial of the step before, extrapolated (of more than three stages: as far as its
    /// terms are to be trusted); zero if there is none. `from` says where in that step this one starts: at its
    /// end (1), or together with it (0).
    void guess(const output* before, const vector& y, const Scalar& h, output& now,
               const Scalar& from = Scalar(1)) {
        auto& Z = now.increments();
        if (before == nullptr) {
            Z.setZero();
            return;
        }
        extrapolation_(*before, y, stages_.method().c, count(), h / before->step(), from, Z);
    }

    /// y1 := the new state.
    void advance(const vector& y, const output& now, vector& y1) const {
        const int s = count();
        y1 = y;
        if (known_.stiffly_accurate) {
            y1 += now.increments().col(s - 1);
        } else {
            for (int j = 0; j < s; ++j) y1 += known_.update[j] * now.increments().col(j);
        }
    }

    /// Makes `now` the continuous polynomial of the accepted step from (t, y) to y1.
    void finish(const Scalar& t, const vector& y, const Scalar& h, const vector& y1, output& now) const {
        now.cover(known_.nodes, t, h, y);
        if (known_.jump && known_.nodes.first_column == 0) now.increments().col(0) = y1 - y;
    }

    /// error := the estimate; f0 = f(t, y) where needs_left_value().
    template <class System>
    int estimate(const System& system, const Scalar& h, const vector& f0, const output& now, vector& error) {
        if (known_.jump) {
            error = now.increments().col(0);
            return 0;
        }
        defect(system, h, known_.left, f0, now, error);
        system.measure(work::solve, [&] { stages_.filter(system, error, scratch_); });
        return 1;
    }

    /// error := (M/(h a) - J)^-1 error with a as in the filter of the estimate; with an M that may be singular the real part,
    /// as a modulus by components would take what M takes to zero elsewhere.
    template <class System>
    int solve_for_defect(const System& system, const Scalar&, vector& error) {
        if constexpr (System::mass_type::identity) {
            system.measure(work::solve, [&] { stages_.filter(system, error, scratch_); });
        } else {
            scratch_.setZero();
            stages_.solve_first(system, error, scratch_);
        }
        return 1;
    }

    bool stiffly_accurate() const { return known_.stiffly_accurate; }
    bool has_stage_order_two() const { return known_.stage_order_two; }
    /// |R(infinity)| < 1, R(infinity) = 1 - b^T A^-1 1.
    bool forgets() const {
        using std::abs;
        return abs(Scalar(1) - known_.update.sum()) < detail::largest_damping<Scalar>();
    }
    /// Of a method that cannot forget, in free steps with a singular M of index 1: y1 moves in the algebraic directions
    /// alone until it satisfies the constraints. What a step leaves there would be handed on as it is, grow from step to
    /// step, and soon be all that the estimates show, of steps however short. As the stages satisfy the constraints, y1 is
    /// then what the method makes of the differential equation on them, of its full order (Hairer-Wanner II.VI.1, the state
    /// space form).
    bool ends_off_constraints() const { return algebraic_ && !algebraic_->empty(); }
    /// One iteration with the factors there are, from what the filtered defect f1 - M u'(1) shows, f1 = f(t1, y1): along the
    /// constraints it is an error of the step, O(h) of which is left by another solve. Returns the number of solves.
    template <class System>
    int end_on_constraints(const System& system, const Scalar& h, const vector& f1, output& now, vector& y1) {
        defect(system, h, known_.right, f1, now, rest_);
        second_.setZero();
        stages_.solve_first(system, rest_, second_);
        stages_.stiff_part(system, rest_, scratch_, second_);
        algebraic_->project(rest_);
        if (all_finite(rest_, system.size())) {
            y1 += rest_;
            now.move_end(rest_);
        }
        return 2;
    }

    /// True if f(t1, y1) is asked for before the step is accepted. Where y1 is no stage, what f does between
    /// the last node and the end of the step is in no stage value, and the estimate is to be made at the
    /// right end as well.
    bool needs_right_value() const { return !known_.stiffly_accurate; }
    /// error := the filtered defect f(t1, y1) - M u'(t1) of the stage polynomial at the right end, of the
    /// order of the other estimate; f1 = f(t1, y1). Returns the number of solves, 0 where there is no such
    /// estimate.
    template <class System>
    int estimate_right(const System& system, const Scalar& h, const vector& f1, const output& now,
                       vector& error) {
        if (known_.stiffly_accurate) return 0;
        defect(system, h, known_.right, f1, now, error);
        system.measure(work::solve, [&] { stages_.filter(system, error, scratch_); });
        return 1;
    }
    /// The same once more filtered: f(t, y + error) in place of f(t, y), which damps what stiff components
    /// that have not decayed yet leave in the estimate (Hairer-Wanner II.IV.8, (8.20)); but not in components
    /// of index 2 and 3, where it takes away whatever the estimate shows. Returns the number of solves.
    template <class System>
    int estimate_again(System& system, const Scalar& t, const vector& y, const Scalar& h, const output& now,
                       vector& f, vector& error) {
        rest_ = error;
        if (known_.jump) {
            stages_.stiff_part(system, error, scratch_, second_);
            error = rest_ - error;
            system.for_each_raised([&](int i, int) { error[i] = rest_[i]; });
            return 1;
        }
        int solves = 1;
        if constexpr (!System::mass_type::identity)
            if (!stages_
                     .has_real_block()) {  // the estimate has no sign, and the way to the constraints has one
                system.evaluate(t, y, f);
                defect(system, h, known_.left, f, now, error);
                second_.setZero();
                stages_.solve_first(system, error, second_);
                ++solves;
            }
        error += y;
        system.for_each_raised([&](int i, int) { error[i] = y[i]; });
        system.evaluate(t, error, f);
        defect(system, h, known_.left, f, now, error);
        system.measure(work::solve, [&] { stages_.filter(system, error, scratch_); });
        if (known_.stiffly_accurate) system.for_each_raised([&](int i, int) { error[i] = rest_[i]; });
        return solves;
    }

    bool estimates_from_start() const { return known_.stiffly_accurate; }
    /// Looks at components of index 2 and 3 of a stiffly accurate method as well by what the polynomial through
    /// the stages alone has at the left end, less the state there. What the filter makes of the defect is G f
    /// there: zero for another solution of the constraints. In components of index 2 the filtered defect shows
    /// what steps hand on, and the rest of the comparison is the error of interpolating the component itself:
    /// nothing of it is handed on, so it counts with weight `rest`.
    ///
    /// In those of index 3, q' = v, v' = f - G^T u, the comparison of u contains derivatives of the errors of v
    /// in this step and in the one before, which cancel for some ratios of the steps and not for others. What
    /// the filtered defect has beyond it is gamma/h times what it shows of v, in units of u, and never cancels for
    /// odd s; in equal steps it stands for the (s - 1) s / gamma-fold in u, as follows from the nodal polynomial
    /// w by w'(0)/w(0) = -s^2, w'(1)/w(0) = (-1)^s s, w''(1)/w'(1) = s^2 - 1.
    template <class System>
    void compare_with_start(const System& system, const output& now, const Scalar& rest,
                            vector& error) const {
        if (!known_.stiffly_accurate) return;
        using std::abs;
        const bool sees_v = !known_.jump && stages_.has_real_block() && count() > 1;
        const Scalar in_u =
            sees_v ? Scalar(Scalar((count() - 1) * count()) / stages_.method().gamma[0]) : Scalar(0);
        system.for_each_raised([&](int i, int power) {
            const Scalar direct = stages_with(known_.start, now, i), filtered = error[i];
            if (power == 2) {
                error[i] = sees_v ? Scalar(in_u * (filtered - direct)) : direct;
            } else {
                const Scalar size = abs(filtered) + rest * abs(direct - filtered);
                error[i] = filtered < Scalar(0) ? Scalar(-size) : size;
            }
        });
    }
    /// For the repeated first step, whose z_0 need not be consistent: in components of index 2 and 3, where
    /// the estimate compares the stages with z_0, the leading Legendre coefficient of the polynomial through
    /// the stages alone takes its place, one order lower, where it is smaller. (Of one stage: nothing.)
    template <class System>
    void without_start(const System& system, const output& now, vector& error) {
        using std::abs;
        if (!known_.stiffly_accurate) return;
        system.for_each_raised([&](int i, int) {
            const Scalar alone = count() > 1 ? stages_with(known_.leading, now, i) : Scalar(0);
            if (abs(alone) < abs(error[i])) error[i] = alone;
        });
    }

    /// Size of the estimate times `ratio`, by which an estimate of order q stands for an error of order p + 1
    /// (below one: the error is smaller), unless the order is reduced (Hairer-Wanner II.IV.15).
    ///
    /// The two differ by factors h |J|, which gain nothing in modes where h |J| is large: there the error of
    /// a stiffly accurate method is about the estimate itself, that of another one about what leaving out the
    /// node 0 changes at the end of the step, as the stages then lie on the solution and y1 on the polynomial
    /// through them. So half of what stiff_part leaves of these, once for every order in between, has to
    /// be within the tolerance as well. (With the whole of it the Prothero-Robinson errors halve, for more
    /// steps in problems where the reduction is brief.) It is computed only while it is larger than what the
    /// ratio promises: one real solve a step where nothing is reduced. size(x, reduced) measures; reduced is
    /// true for this second part.
    template <class System, class Size>
    Scalar error_size(const System& system, const output& now, const Scalar& ratio, const vector& error,
                      long& solves, Size&& size) {
        const Scalar promised = size(error, false) * ratio;
        if (known_.stiffly_accurate && !(ratio < Scalar(1))) return promised;
        if (known_.stiffly_accurate) {
            rest_ = error;
        } else {
            rest_.setZero();
            for (int j = 0; j < count(); ++j) rest_ += known_.ends[j] * now.increments().col(j);
            leave_to_constraints<System>(rest_);
        }
        Scalar left = size(rest_, true) / 2;
        const int orders = known_.order + 1 - estimate_power() + (known_.stiffly_accurate ? 0 : 1);
        for (int k = 0; k < orders && left > promised; ++k) {
            stages_.stiff_part(system, rest_, scratch_, second_);
            leave_to_constraints<System>(rest_);
            ++solves;
            left = size(rest_, true) / 2;
        }
        return left <= promised ? promised : left;
    }

    /// How fast the Legendre coefficients of the stage polynomial fall: (|a_s| / |a_{s-2}|)^{1/2} in the
    /// weighted norm; 0 < decay <= 1. Of free steps.
    template <class Norm>
    Scalar decay(const output& now, const Norm& norm) {
        using std::sqrt;
        const vector& norm_weights = norm.weights();
        Scalar size[3] = {Scalar(0), Scalar(0), Scalar(static_cast<int>(norm_weights.size()))};
        for (int r = 0; r < 2; ++r) {
            weigh_coefficient(r, now);
            for (int i = 0; i < scratch_.size(); ++i) {
                const Scalar a = scratch_[i] * norm_weights[i];
                size[r] += a * a;
            }
        }
        norm.sums()(size, 3);
        components_ = size[2];
        last_coefficient_ = sqrt(size[0]);
        const Scalar least = Scalar(1) / 10000;
        if (!(size[1] > Scalar(0))) return Scalar(1);
        const Scalar q = sqrt(last_coefficient_ / sqrt(size[1]));
        return q > Scalar(1) ? Scalar(1) : q < least ? least : q;
    }

    /// True if some component of y' is the same at all nodes of the step, and not zero: its stages lie on a line
    /// through y, z_j = c_j z_s / c_s, up to rounding.
    bool sees_constant_slope(const output& now) const {
        using std::abs;
        const int s = count(), last = s - 1;
        const auto& c = stages_.method().c;
        const auto& Z = now.increments();
        for (int i = 0; i < Z.rows(); ++i) {
            const Scalar most = 64 * std::numeric_limits<Scalar>::epsilon() * abs(Z(i, last));
            int on_line = 0;
            while (on_line < last && abs(Z(i, on_line) * c[last] - c[on_line] * Z(i, last)) <= most)
                ++on_line;
            if (on_line == last && last > 0 && most > Scalar(0)) return true;
        }
        return false;
    }

    /// True if output_error() means something: two stages at least, and the stages alone make the polynomial.
    bool knows_output_error() const {
        return count() > 1 && !(known_.jump && known_.nodes.first_column == 0);
    }
    /// About the largest error of the continuous solution over the step, O(h^{s+1}): twice the Legendre
    /// coefficient that would come next, taken to be to the last one as this is to those before. Nothing of f
    /// and J enters, so that stiff components count in full.
    template <class Norm>
    Scalar output_error(const output& now, const Norm& norm) {
        using std::sqrt;
        const Scalar q = decay(now, norm);
        return components_ == Scalar(0) ? Scalar(0) : Scalar(2 * q * last_coefficient_ / sqrt(components_));
    }

  private:
    /// Takes out of x what end_on_constraints() mends.
    template <class System>
    void leave_to_constraints([[maybe_unused]] vector& x) const {
        if constexpr (!System::mass_type::identity)
            if (algebraic_) algebraic_->remove(x);
    }
    /// The functional w of component i of the stages.
    static Scalar stages_with(const weights& w, const output& now, int i) {
        Scalar sum = w[0] * now.increments()(i, 0);
        for (int j = 1; j < w.size(); ++j) sum += w[j] * now.increments()(i, j);
        return sum;
    }
    /// scratch_ := a_s (r = 0) or a_{s-2} (r = 1) of the stage polynomial.
    void weigh_coefficient(int r, const output& now) {
        scratch_ = top_(0, r) * now.increments().col(known_.nodes.first_column);
        for (int j = 1; j < known_.nodes.size; ++j)
            scratch_ += top_(j, r) * now.increments().col(known_.nodes.first_column + j);
    }
    template <class System>
    void defect(const System& system, const Scalar& h, const weights& slope, const vector& f,
                const output& now, vector& error) {
        scratch_ = (slope[0] / h) * now.increments().col(0);
        for (int j = 1; j < count(); ++j) scratch_ += (slope[j] / h) * now.increments().col(j);
        error = f;
        add_mass_times(system.mass(), Scalar(-1), scratch_.data(), error.data(), system.size());
    }

    transformed_stages<vector, Stages, typename Space::blocks> stages_;
    facts known_;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 2> top_;  // z -> a_s, a_{s-2}
    // Of few stages too where a method of more may follow, whose guess is cut.
    [[no_unique_address]] std::conditional_t<(Space::columns < 0 || Space::columns > 3),
                                             stage_extrapolation<Scalar, Space::columns>,
                                             whole_extrapolation<Space::columns>>
        extrapolation_;
    std::unique_ptr<mass_kernel<Scalar>> algebraic_;  // where ends_off_constraints()
    vector scratch_, second_, rest_;
    Scalar last_coefficient_{0},
        components_{0};  // of the decay: a_s, and how many components all processes have
};

}  // namespace stagecraft
