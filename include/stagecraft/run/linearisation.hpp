// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include <stagecraft/linear/norms.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/run/initial_step.hpp>
#include <stagecraft/stages/newton.hpp>

namespace stagecraft {

/// What a factorisation costs, in iterations; 0 where that is little, or not known.
template <class Step, class System>
auto factorisation_cost(Step& method, const System& system) {
    if constexpr (requires { method.stages().factorisation_cost(system); })
        return method.stages().factorisation_cost(system);
    else
        return typename System::scalar(0);
}

/// What the linear systems of an attempt are like: factored, singular (or not finite), or such that a guard forbids the
/// step.
enum class linear_state { factored, singular, forbidden };

/// A step of h whose matrices have just been factored, as guards see it before its stage equations are solved.
template <class System, class Stages, class Slope, class Norm>
struct factored_step {
    using scalar = typename System::scalar;
    const System& system;
    Stages& stages;
    Slope& slope;  ///< slope() is f at the left end
    const Norm& norm;
    scalar h;
    bool longer;  ///< by half at least than the step before
};
// clang deduces no arguments of aggregates before version 17.
template <class System, class Stages, class Slope, class Norm>
factored_step(const System&, Stages&, Slope&, const Norm&, typename System::scalar, bool)
    -> factored_step<System, Stages, Slope, Norm>;

/// The linearisation of the stage equations that Newton's iteration uses: the Jacobian, which the system
/// holds, and how old it is; for which step size and method its matrices are factored; how well it serves
/// (theta, the contraction seen last). A Jacobian is kept while theta <= 1/1000 (Hairer-Wanner II.IV.8), longer
/// where a factorisation is known to cost many iterations, and for ever where it is constant.
template <class System, class Vector>
class linearisation {
  public:
    using scalar = typename Vector::Scalar;

    explicit linearisation(int n) : negligible_(n) {}

    /// A run begins: nothing is known.
    void start() {
        factored_for(scalar(0), 0);
        theta_ = fresh_theta_ = scalar(0);
        hold_ = scalar(6) / 5;
        jacobian_ = age::wanted;
        ahead_ = contradicted_ = false;
    }
    bool wanted() const { return jacobian_ == age::wanted; }
    /// Evaluated in this step.
    bool fresh() const { return jacobian_ == age::fresh; }
    /// True if the next evaluation needs f at the left end of the step.
    bool needs_left_value() const { return System::finite_difference && wanted(); }
    const scalar& theta() const { return theta_; }
    /// Newton's iteration contracts so well that another Jacobian gains nothing, or less than it costs.
    bool serves_well() const { return hold_ > scalar(1); }
    /// The factor by which the next step could grow and does not, so that the factors serve it; 1 where they do
    /// not serve well.
    const scalar& hold() const { return hold_; }
    /// The problem says so, and the first step did not show otherwise.
    bool constant(System& system) const { return !contradicted_ && system.constant_jacobian(); }

    /// Evaluates the Jacobian for a step h from (t, y), with f0 = f(t, y) where differences need it. `before`
    /// is the step before, null in the first; `ahead` says that its solution may be extrapolated; point is
    /// scratch. Two fifths into the step the Jacobian serves all stages best; not further than the last step
    /// was long, as that is where the state comes from. (Differences need f there as well: they stay at the
    /// left end, where it is known.)
    template <class Output>
    void evaluate(System& system, const scalar& t, const Vector& y, const Vector& f0, const scalar& h,
                  const Output* before, bool ahead, const options<scalar>& o, Vector& point) {
        using std::abs;
        scalar reach(0);
        if constexpr (System::finite_difference) reach = look_for_negligible(system, y, f0, h, before, o);
        ahead_ = !System::finite_difference && ahead;
        if (ahead_) {
            const scalar last = before->step(), at = t + (abs(h) < abs(last) ? h : last) * 2 / 5;
            before->evaluate(at, point);
            system.evaluate_jacobian(at, point, f0, negligible_);
        } else {
            system.evaluate_jacobian(t, y, f0, negligible_, reach);
            // A derivative may be infinite where f is not, as that of sqrt(y) at 0: then a little further along the
            // solution, if it moves.
            if constexpr (System::automatic) {
                if (System::mass_type::identity && !system.finite_jacobian()) {
                    system.evaluate(t, y, point);
                    point = y + (h / 1000) * point;
                    system.evaluate_jacobian(t, point, f0, negligible_);
                }
            }
        }
        jacobian_ = age::fresh;
        factored_for(scalar(0), 0);
    }

    /// Factors the systems of a step h with method number k, unless they are already: for h, or for one that
    /// differs from it by no more than rounding of large t explains, which slows the iteration by as little.
    /// forbids() is asked once they are.
    template <class Stages, class Forbids>
    linear_state factor(const System& system, Stages& stages, const scalar& h, int k, Forbids&& forbids,
                        long& factorisations) {
        if (factored_method_ == k && factored_within(h, scalar(1) / 100000)) return linear_state::factored;
        ++factorisations;
        factored_for(scalar(0), 0);
        if (!stages.factor(system, h)) return linear_state::singular;
        if (forbids()) return linear_state::forbidden;
        factored_for(h, k);
        return linear_state::factored;
    }
    /// The systems have been factored for a step that differs from h by at most `part` of it.
    bool factored_within(const scalar& h, const scalar& part) const {
        using std::abs;
        return factored_h_ == h || abs(factored_h_ - h) < part * abs(h);
    }
    /// The systems have been factored elsewhere.
    void factored_for(const scalar& h, int k) {
        factored_h_ = h;
        factored_method_ = k;
    }

    /// Newton's iteration has converged; `first` in the run. With a constant Jacobian its second increment is
    /// what rounding, or differences, leave of the first. Where it is not, the claim is not believed: one
    /// iteration a step would leave errors that nothing sees. `cost`: of a factorisation, in iterations.
    void solved(const newton_outcome<scalar>& newton, const scalar& cost, bool first) {
        using std::sqrt;
        const scalar exact = System::finite_difference ? scalar(1) / 1000000
                                                       : scalar(sqrt(std::numeric_limits<scalar>::epsilon()));
        if (first) contradicted_ = contradicted_ || newton.theta > exact;
        if (newton.theta > scalar(0)) theta_ = newton.theta;
        if (fresh()) fresh_theta_ = theta_;
        const bool serves = theta_ <= scalar(1) / 1000 || is_worth_keeping(newton.iterations, cost);
        hold_ = serves ? longest_hold(newton.iterations, cost) : scalar(1);
    }
    /// Another Jacobian may be better than the one there is.
    bool may_be_renewed(System& system) const { return !fresh() && !constant(system); }
    /// It is wanted then.
    void renew(System& system) {
        if (may_be_renewed(system)) jacobian_ = age::wanted;
    }
    /// The state has been moved: what there is serves another one.
    void moved() {
        jacobian_ = age::wanted;
        factored_for(scalar(0), 0);
    }
    /// The error of the step is too large: with the next, smaller one the Jacobian is replaced as well if it
    /// served badly.
    void rejected(System& system) {
        if (!serves_well()) renew(system);
    }
    /// Jacobians of other places have been tried for a step of h with method number k: `solved` by them it is that of the right
    /// end, and factored there; else it is back at the left one.
    void tried_elsewhere(bool solved, const scalar& h, int k) {
        ahead_ = false;
        if (solved) jacobian_ = age::kept;
        factored_for(solved ? h : scalar(0), k);
    }
    /// Where the extrapolation went astray the Jacobian did: true if it is wanted at the left end now.
    bool stay_behind() {
        if (ahead_) jacobian_ = age::wanted;
        return ahead_;
    }
    /// The step has been accepted.
    void stepped(System& system) {
        jacobian_ = age::kept;
        if (!serves_well()) renew(system);
    }

    /// The method whose systems have been factored.
    int factored_method() const { return factored_method_; }
    /// Calls factor(k, h) for the method and the step of the factors there are, if any.
    template <class Factor>
    void factor_again(Factor&& factor) const {
        if (!(factored_h_ == scalar(0))) factor(factored_method_, factored_h_);
    }

    /// What the next step depends on (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        bag(factored_h_, theta_, fresh_theta_, hold_, factored_method_, jacobian_, ahead_, contradicted_);
    }

  private:
    enum class age : unsigned char { wanted, kept, fresh };

    /// Increments of differences are to be small beside what a component is, or moves by: h f0 where it is not stiff. In
    /// stiff components f0 is dominated by J times the last error, so h f0 says nothing about how far they move: they are
    /// not taken to move faster than in the step before (which may have been an eighth of this one), and in the first one
    /// not by more than an automatic first step would have it. Returns the length of that one, later 0.
    template <class Output>
    scalar look_for_negligible(const System& system, const Vector& y, const Vector& f0, const scalar& h,
                               const Output* last, const options<scalar>& o) {
        using std::abs;
        scalar reach = abs(h);
        if (last == nullptr) {
            set_weights(o, y, negligible_);
            const weighted_root_mean_square norm(negligible_, system.sums());
            const scalar first = initial_step(system.mass(), y, f0, norm, reach);
            if (first < reach) reach = first;
        }
        for (int i = 0; i < system.size(); ++i) {
            const scalar small = absolute_tolerance(o, i) / o.rtol / 1000;
            scalar moved = reach * abs(f0[i]);
            if (last != nullptr) {
                const scalar seen = 8 * abs(y[i] - last->y0()[i]);
                if (seen < moved) moved = seen;
            }
            negligible_[i] = moved > small ? moved : small;
        }
        return last == nullptr ? reach : scalar(0);
    }

    /// As the Jacobian gets older theta grows, and with it the number of iterations: of those that the next step
    /// needs a new Jacobian saves all but log(2 theta) / log(theta when new), if theta doubles. It is due when they
    /// make a tenth of its factorisation. (By the work alone it could wait longer; but what the iterations leave
    /// grows as well, and errors become five times as large.) Nothing is kept beyond 1/4.
    bool is_worth_keeping(int iterations, const scalar& cost) const {
        using std::log;
        if (!(cost > scalar(0)) || theta_ > scalar(1) / 4) return false;
        const scalar least = scalar(1) / 1000, when_new = fresh_theta_ < least ? least : fresh_theta_;
        return 10 * scalar(iterations) * (scalar(1) - log(2 * theta_) / log(when_new)) <= cost;
    }
    /// A step that is held although it could grow by f makes f times the iterations for the same length, and
    /// saves a factorisation: f iterations <= iterations + cost. Half of that is left to all else that a step
    /// costs.
    static scalar longest_hold(int iterations, const scalar& cost) {
        const scalar least = scalar(6) / 5, by_work = scalar(1) + cost / scalar(2 * iterations);
        return by_work < least ? least : by_work < scalar(2) ? by_work : scalar(2);
    }

    Vector negligible_;  // sizes below which differences need not tell components apart
    scalar factored_h_{0}, theta_{0}, fresh_theta_{0};  // theta, and theta when the Jacobian was new
    scalar hold_ = scalar(6) / 5;
    int factored_method_ = 0;
    age jacobian_ = age::wanted;
    bool ahead_ = false, contradicted_ = false;
};

}  // namespace stagecraft
