// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include <stagecraft/judge/guards/jumps.hpp>
#include <stagecraft/judge/order.hpp>
#include <stagecraft/judge/step_size.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/end_slope.hpp>
#include <stagecraft/run/step_plan.hpp>
#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// An attempt at a step from (t, y) whose stage equations are solved.
template <class Vector, class Output>
struct trial_step {
    using scalar = typename Vector::Scalar;
    const planned_step<scalar>& plan;
    const scalar& t;
    const Vector& y;
    const Vector& weights;  ///< of the norm in which the tolerance is 1
    end_slope<Vector>& f;   ///< f at one of the ends
    Vector& y1;             ///< the state at t_next
    Output& now;            ///< the stages, then the continuous solution
    scalar between{0};      ///< about its error between the ends, where that is asked for
};

/// How often the present step has been refused: at all, for the size of its error, and by Newton's iteration.
struct refusals {
    int all = 0, for_error = 0, by_newton = 0;
};

/// Judges attempts whose stage equations are solved, and says what follows: the error of the step, the size
/// of the next one, with several methods the next method. Holds what it has to remember for it.
template <class Vector, int Methods>
class acceptance {
    using scalar = typename Vector::Scalar;

  public:
    acceptance(const options<scalar>& o, const scalar& t0, int n)
        : rtol_(o.rtol),
          controller_(o.control),
          jumps_(o, t0),
          error_(n),
          weights_(n),
          continuous_(o.continuous) {
        weights_.setZero();
    }

    /// Number of the method in use.
    int method() const { return order_.current(); }
    /// Makes method number k known.
    template <class Step, class System>
    void prepare(int k, Step& m, const System& system) {
        ratio_[k] = m.estimate_ratio(rtol_);
        if constexpr (Methods > 1) {
            order_.prepare(k,
                           {m.count(), m.estimate_power(), smooth_ratio(system, k),
                            m.stages().work(system.total_size())},
                           rtol_);
        }
    }
    /// Newton's iteration has failed though the Jacobian is new; `again` in this step: another method is to try.
    void newton_failed(bool again) {
        if constexpr (Methods > 1) order_.newton_failed(again);
    }

    /// The error of an attempt, of tolerance 1; `first` in the run.
    template <class Step, class System>
    scalar error(Step& method, System& system, trial_step<Vector, typename Step::output>& trial,
                 const refusals& refused, bool first, report<scalar>& counts) {
        auto reading = jumps_.read(method, ratio_[order_.current()], trial.t, trial.plan.h);
        weigh(method, system, trial, reading.ratio, refused);
        counts.error_solves += method.estimate(system, trial.plan.h, trial.f.value(), trial.now, error_);
        if (system.largest_index() > 1) {
            const scalar s = scalar(method.estimate_power() - 1);
            method.compare_with_start(system, trial.now, s / (s + scalar(1)) / share_, error_);
        }
        scalar err = estimate_size(method, system, trial, reading.ratio, refused, counts);
        if (err >= scalar(1))
            err = second_estimate(method, system, trial, reading.ratio, refused, first, counts, err);
        if (err < scalar(1) && method.needs_right_value()) {
            const Vector& f1 = trial.f.right(system, trial.plan.t_next, trial.y1);
            if (const int solves = method.estimate_right(system, trial.plan.h, f1, trial.now, error_)) {
                counts.error_solves += solves;
                raise(err, weighted_norm(error_, trial.weights, system.size(), system.sums()) *
                               method.right_ratio(reading.ratio));
            }
        }
        const auto expected = [&] { return controller_.expected(trial.plan.h, method.estimate_power()); };
        if (!first && jumps_.surprised(reading, err, expected, refused.for_error > 0)) {
            controller_.forget();
            reading.ratio = reading.across;
            weigh(method, system, trial, reading.ratio, refused);
            raise(err, estimate_size(method, system, trial, reading.ratio, refused, counts));
        }
        err = jumps_.judge(method, system, reading, trial.plan.h, err, error_, counts.error_solves,
                           size_of(system, trial));
        if (continuous_)
            raise(err, method.output_error(trial.now, trial.weights, system.sums()));
        else if (err < scalar(1))  // plausible() is no more than output_error()
            raise(err, plausible(method, system, trial, refused));
        if (first && err < scalar(1)) raise(err, unresolved(method, system, trial, reading.ratio, counts));
        return err;
    }

    /// The next step after an accepted one of error err < 1, and the method that makes it. `newton` is what
    /// the iteration told, theta its last known contraction; a step that could grow by `hold` at most stays as
    /// long as it is, for the factors there are.
    template <class Step, class System>
    scalar after_accepted(Step& method, const System& system,
                          const trial_step<Vector, typename Step::output>& trial, scalar err,
                          const newton_outcome<scalar>& newton, const scalar& theta, scalar hold,
                          const refusals& refused) {
        const auto sums = system.sums();
        last_h_ = trial.plan.h;
        last_error_ = err;
        last_between_ = trial.between;
        last_method_ = this->method();
        if (jumps_.accepted(method)) {
            controller_.forget();
            const scalar smooth = smooth_ratio(system, this->method());
            if (smooth < scalar(1)) err *= smooth;
        }
        // An error of multipliers that many refusals have not explained was there before: no trend that goes on.
        if (share_ < scalar(1) && refused.for_error > 3) controller_.forget();
        const int most = usual_iterations(method.coupled_stages_count());
        const scalar safety = usual_safety() * scalar(2 * most + 1) / scalar(2 * most + newton.iterations);
        scalar factor = controller_.after_accepted(trial.plan.h, err, method.estimate_power(), safety);
        if (refused.all > 0 && factor > scalar(1)) factor = scalar(1);
        if constexpr (Methods > 1) {
            order_.accepted();
            if (order_.wants_evidence() && refused.all == 0 && !jumps_.doubted()) {
                const scalar decay = method.decay(trial.now, trial.weights, sums);
                const scalar change = order_.decide({trial.plan.h, err, decay, theta, newton.iterations,
                                                     method.stages().linear_work(system)});
                if (change > scalar(0)) {
                    factor = change;
                    if (hold > scalar(6) / 5) hold = scalar(6) / 5;  // the factors were another method's
                    controller_.forget();
                }
            }
        }
        if (factor >= scalar(1) && factor <= hold) factor = scalar(1);
        const scalar next = trial.plan.h * factor;
        bool bold = jumps_.bold(next, trial.plan.t_next);
        if (bold) {  // the component may be another process's
            scalar seen(method.sees_constant_slope(trial.now) ? 1 : 0);
            sums(&seen, 1);
            bold = seen > scalar(0);
        }
        return jumps_.bounded(next, trial.plan.t_next, bold);
    }

    /// True if a step of h, the smallest that t resolves, may be accepted with error err >= 1.
    bool passes(const scalar& h, const scalar& err, int power) const {
        using std::abs;
        using std::pow;
        if (last_h_ == scalar(0)) return false;
        return jumps_.passes(err, last_error_ * scalar(pow(abs(h / last_h_), scalar(power))));
    }

    /// The step to try after one from t whose error was too large, or not finite; `first` in the run. An error
    /// that is not smaller than at the refusal before does not follow the step at all (a stiff component that the
    /// step before left beside the smooth solution, say, until h |J| is about one): then by the largest factor,
    /// but not with components of index 2 and 3, whose estimates contain what earlier steps left of them anyway.
    scalar after_rejected(const scalar& t, const scalar& h, const scalar& err, int power, bool first,
                          const refusals& refused) {
        if (!(err - err == scalar(0))) return h / 8;
        if (first) return h / 10;
        const bool stays = share_ == scalar(1) && refused.for_error > 1 && !jumps_.smaller(err);
        jumps_.refused(t, h, err, power, refused.for_error > 1);
        if (stays) return h / 8;
        return h * controller_.after_rejected(err, power, usual_safety());
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(controller_, order_, jumps_, last_h_, last_method_, last_error_, last_between_);
    }

  private:
    /// The size of a vector, by the weights in which this step is judged, or by those of what the step control can follow.
    template <class System, class Trial>
    auto size_of(System& system, const Trial& trial) const {
        return [&, this](const Vector& x, bool reduced) {
            const Vector& judged = system.largest_index() > 1 ? weights_ : trial.weights;
            return weighted_norm(x, reduced ? system.weights_to_follow(trial.weights) : judged, system.size(),
                                 system.sums());
        };
    }
    /// The size of the estimate in error_, of which 1 stands for `ratio`.
    template <class Step, class System, class Trial>
    scalar estimate_size(Step& method, System& system, const Trial& trial, const scalar& ratio,
                         const refusals& refused, report<scalar>& counts) {
        scalar whole =
            method.error_size(system, trial.now, ratio, error_, counts.error_solves, size_of(system, trial));
        if (system.largest_index() > 1 && share_ < scalar(1) && refused.for_error < 4)
            raise(whole, unexplained(system, ratio));
        return whole;
    }
    /// What becomes of an estimate err >= 1 where the step before may have left it.
    template <class Step, class System, class Trial>
    scalar second_estimate(Step& method, System& system, const Trial& trial, const scalar& ratio,
                           const refusals& refused, bool first, report<scalar>& counts, scalar err) {
        if (first || refused.all > 0) {
            const scalar once = err;
            counts.error_solves +=
                method.estimate_again(system, trial.t, trial.y, trial.plan.h, trial.now, trial.y1, error_);
            if (first && refused.all > 0) method.without_start(system, trial.now, error_);
            method.advance(trial.y, trial.now, trial.y1);
            err = estimate_size(method, system, trial, ratio, refused, counts);
            if (System::mass_type::identity && !first &&
                jumps_.across(trial.plan.h, once, method.estimate_power(), refused.for_error > 0))
                raise(err, once / stiff_share());
        }
        if (inherited(err, refused)) {
            system.weigh_raised(weights_, scalar(0));
            err = estimate_size(method, system, trial, ratio, refused, counts);
        }
        return err;
    }
    /// The weights in which an estimate that is multiplied by `ratio` then is measured; differ from those of
    /// the trial with components of index 2 and 3 only. Their errors are of the order of the estimate itself
    /// (HLR89, Theorems 4.4 and 6.1: |h| e_z and h^2 e_u are O(h^{s+1}) for Radau IIA), not
    /// of that of y, so that the ratio says nothing about them. And what the estimate shows of them comes from
    /// two steps: by u'(0) - z_n it is the error (-1)^s K h^s of the derivative of the collocation polynomial
    /// at the left end, less that of z_n, s K h^s of the step before (the nodal polynomial of Radau IIA has
    /// slopes in this proportion at 1 and 0). What this step leaves in z_{n+1} is the share
    ///     s g / (s + g),  g = (h_n / h_{n-1})^s,
    /// of it: z_n hands nothing on, and without this an error once made would ask for ever smaller steps. What
    /// an estimate shows beyond that, the error of interpolating z, comes from this step alone: it counts
    /// with the share of equal steps, s / (s + 1), whatever g is. (With g the steps of mechanical systems went up
    /// and down, and every second one was refused.)
    ///
    /// After a method of other order has made the step before, z_n has an error that g knows nothing of. One
    /// of higher order leaves little, as if g were infinite. One of lower order leaves more than this step
    /// makes, which is why it has been given up: nothing then tells the two apart, and what z_n brings into
    /// index 3, s e_z / h, is what counts: the share 1 / (s - 1). As z_n does not change with the step, both
    /// end where smaller steps make g smaller. Methods that are not stiffly accurate are left alone.
    template <class Step, class System, class Trial>
    void weigh(const Step& method, const System& system, const Trial& trial, const scalar& ratio,
               const refusals& refused) {
        using std::abs;
        using std::pow;
        share_ = scalar(1);
        if (system.largest_index() < 2) return;
        weights_ = trial.weights;
        if (!method.estimates_from_start()) return;
        const scalar s = scalar(method.estimate_power() - 1);
        share_ = s;  // z_0 is taken to be consistent
        if (!(last_h_ == scalar(0))) {
            const scalar grown = pow(abs(trial.plan.h / last_h_), s), regular = s * grown / (s + grown);
            const int change = this->method() - last_method_;
            if (change == 0 || (change < 0 && refused.for_error > 3))
                share_ = regular;
            else if (change > 0)
                share_ = regular * (s - scalar(1)) < scalar(1) ? regular : scalar(1) / (s - scalar(1));
        }
        system.weigh_raised(weights_, share_ * (ratio < raised_ratio() ? raised_ratio() / ratio : scalar(1)));
    }
    /// In the first step: the error of its continuous solution u between the nodes, by the standard of the
    /// estimate. A solution that starts on the smooth one of a stiff equation has stages on it wherever they lie,
    /// so that across many of its oscillations the estimate is as small as 1/|J|; but u leaves it in between, and
    /// (M/(h a) - J)^-1 of its defect there tells how far, whatever J is. Later steps start from one that was
    /// judged. Algebraic components, whose start need not be consistent, are left out: the solve takes what they
    /// do to the others away. One evaluation of f, one solve.
    template <class Step, class System>
    static scalar unresolved(Step& method, System& system,
                             const trial_step<Vector, typename Step::output>& trial, const scalar& ratio,
                             report<scalar>& counts) {
        if (!method.implicit()) return scalar(0);
        auto u = trial.now;
        method.finish(trial.t, trial.y, trial.plan.h, trial.y1, u);
        const scalar t = trial.t + trial.plan.h * farthest_from(u.nodes());
        Vector error(system.size());
        system(t, u(t), error);
        const Vector slope = u.derivative(t);
        add_mass_times(system.mass(), scalar(-1), slope.data(), error.data(), system.size());
        counts.error_solves += method.solve_for_defect(system, trial.plan.h, error);
        drop_algebraic(system.mass(), error);
        return weighted_norm(error, trial.weights, system.size(), system.sums()) *
               (ratio < scalar(1) ? ratio : scalar(1));
    }
    /// The middle of the widest gap between 0, the nodes and 1.
    template <class Nodes>
    static scalar farthest_from(const Nodes& nodes) {
        scalar widest(0), middle(0);
        for (int i = -1; i < nodes.size; ++i) {
            const scalar left = i < 0 ? scalar(0) : nodes.c[i];
            scalar right(1);
            for (int j = 0; j < nodes.size; ++j)
                if (nodes.c[j] > left && nodes.c[j] < right) right = nodes.c[j];
            if (right - left > widest) widest = right - left, middle = (left + right) / 2;
        }
        return middle;
    }
    /// x_j := 0 where column j of M is zero, or where that is not known its row sum.
    template <class Mass>
    static void drop_algebraic(const Mass& mass, Vector& x) {
        if constexpr (!Mass::identity) {
            Vector size = Vector::Zero(x.size());
            if constexpr (has_entries<Mass>) {
                for (const auto& e : mass.entries()) size[e.column] = scalar(1);
            } else {
                const Vector ones = Vector::Ones(x.size());
                add_mass_times(mass, scalar(1), ones.data(), size.data(), static_cast<int>(x.size()));
            }
            for (int j = 0; j < x.size(); ++j)
                if (size[j] == scalar(0)) x[j] = scalar(0);
        }
    }
    /// True if what is left of the error after several attempts no longer falls with the step: the iteration of the
    /// step before has left so much in the constraints, which takes |h| e_z of this order to mend in one step of
    /// any length. Then z says nothing more about the step; it is wrong by that much until the next one.
    bool inherited(const scalar& err, const refusals& refused) const {
        return share_ < scalar(1) && refused.for_error > 3 && err >= scalar(1) && err < most_inherited() &&
               !jumps_.smaller(err);
    }
    /// What an error may be though its estimate is smaller: a quarter of what that of the step before lets expect, in
    /// proportion to output_error(), but no more than output_error(), and nothing where that is below one. Of a shorter
    /// step less is expected, as the error at its end falls faster, with h^{2s} beside h^{s+1} (Radau IIA). An estimate
    /// that changes its sign with the phase of the solution passes zero, and believing it the steps would grow far
    /// beyond those of the solution. Asked of the first attempt at a step, from three stages on: with two it changes
    /// which steps are taken, and nothing in their errors.
    template <class Step, class System, class Trial>
    scalar plausible(Step& method, const System& system, Trial& trial, const refusals& refused) {
        if (system.largest_index() > 1 || !method.knows_output_error() || method.count() < 3)
            return scalar(0);
        trial.between = method.output_error(trial.now, trial.weights, system.sums());
        if (trial.between < scalar(1) || refused.all > 0 || this->method() != last_method_ ||
            !(last_between_ > scalar(0)))
            return scalar(0);
        using std::abs;
        using std::pow;
        scalar share = last_error_ / last_between_ / 4;
        const scalar shorter = abs(trial.plan.h / last_h_);
        if (shorter < scalar(1)) share *= scalar(pow(shorter, scalar(method.count() - 1)));
        return share < scalar(1) ? share * trial.between : trial.between;
    }
    /// What of the estimate cannot come from z_n, whose error the step before has left within some twenty
    /// tolerances: beyond twice that the iteration may have gone to another solution of the constraints. Asked of
    /// the first attempts at a step only: what smaller steps do not take away does come from z_n.
    template <class System>
    scalar unexplained(const System& system, const scalar& ratio) {
        system.weigh_raised(weights_, scalar(1) / share_);
        const scalar whole = weighted_norm(error_, weights_, system.size(), system.sums()) * ratio;
        system.weigh_raised(weights_, share_);
        return whole - most_inherited();
    }
    /// What an estimate of 1 by method k stands for where f is smooth, of an error that any component may have.
    template <class System>
    scalar smooth_ratio(const System& system, int k) const {
        return system.largest_index() > 1 && ratio_[k] < raised_ratio() ? raised_ratio() : ratio_[k];
    }
    /// An estimate of one in components of index 2 and 3 stands for an error of a quarter, so that |h| e_z
    /// stays within about ten tolerances; with one it would stay within three, for a third more steps.
    static scalar raised_ratio() { return scalar(1) / 4; }
    static scalar most_inherited() { return scalar(40); }
    /// err := the larger one; NaN is.
    static void raise(scalar& err, const scalar& other) {
        if (!(other <= err)) err = other;
    }
    /// Across a jump of f a stiff component ends a step with an error of about what its estimate shows, filtered
    /// once; filtered twice, of about the square. It decays with the next steps: so many tolerances are let pass. With a
    /// singular M nothing is asked: what algebraic components show, filtered once, does not fall with the step.
    static scalar stiff_share() { return scalar(10); }
    static scalar usual_safety() { return scalar(9) / scalar(10); }

    scalar rtol_;
    std::array<scalar, static_cast<std::size_t>(Methods)> ratio_{};
    step_size_controller<scalar> controller_;
    order_controller<scalar, Methods> order_{};
    jump_guard<scalar> jumps_;
    Vector error_, weights_;
    scalar share_{1};   // of the estimate in components of index 2 and 3 that this step has made
    scalar last_h_{0};  // of the step accepted last, and the number of its method
    int last_method_ = 0;
    bool continuous_;
    scalar last_error_{0}, last_between_{0};  // by the estimate and by output_error()
};

}  // namespace stagecraft
