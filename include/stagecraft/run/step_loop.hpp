// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <stdexcept>

#include <stagecraft/judge/judge.hpp>
#include <stagecraft/judge/unsolved.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/run/across_kink.hpp>
#include <stagecraft/run/attempts.hpp>
#include <stagecraft/run/complete_step.hpp>
#include <stagecraft/run/constraints_determine.hpp>
#include <stagecraft/run/end_slope.hpp>
#include <stagecraft/run/find_consistent_start.hpp>
#include <stagecraft/run/guarded.hpp>
#include <stagecraft/run/homotopy.hpp>
#include <stagecraft/run/inconsistent_start.hpp>
#include <stagecraft/run/initial_step.hpp>
#include <stagecraft/run/linearisation.hpp>
#include <stagecraft/run/look_at_end.hpp>
#include <stagecraft/run/measured_step.hpp>
#include <stagecraft/run/newton_room.hpp>
#include <stagecraft/run/prepare_method.hpp>
#include <stagecraft/run/solve_from_guess.hpp>
#include <stagecraft/run/step_plan.hpp>
#include <stagecraft/run/tolerance_norm.hpp>
#include <stagecraft/status.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft {

/// The algorithm of a run, one step at a time: plan, linearise, solve the stage equations, judge, then accept or
/// propose another. What a run offers besides is in integrator.hpp.
template <class Method, class Problem, class Vector>
class step_loop {
  public:
    using scalar = typename Vector::Scalar;
    using steps = detail::steps_of<std::decay_t<decltype(detail::as_tuple(std::declval<const Method&>()))>,
                                   Vector, typename system<Problem, Vector>::blocks>;
    using output_type = dense_output<Vector, steps::max_stages>;
    static constexpr bool distributed = !system<Problem, Vector>::sums_type::complete;
    static_assert(std::is_same_v<scalar, typename steps::scalar>,
                  "method and state must have the same scalar type");

    /// Takes one accepted step; false if there is none to take (t1 reached) or none could be taken
    /// (status()).
    bool step() {
        if (finished()) return false;
        if (plan_.afresh(t_)) begin_afresh();
        if (!started_ && !start()) {
            system_.failed_elsewhere();
            return false;
        }
        attempts_.begin();
        progress now = progress::again;
        while (now == progress::again) {
            now = visit_current([this](auto& method) { return this->attempt(method); });
            if ((now != progress::accepted || finished()) && system_.failed_elsewhere())
                now = give_up(status::non_finite);
        }
        return now == progress::accepted;
    }
    bool finished() const { return t() == plan_.last() || status_ != status::success; }
    /// Where the run is.
    const scalar& t() const { return plan_.time_at(t_); }

  protected:
    using system_type = stagecraft::system<Problem, Vector>;
    using norm_type = tolerance_norm<Vector, typename system_type::sums_type, system_type::may_be_raised>;
    using guards_type =
        decltype(detail::guards_in<system_type>(std::declval<typename detail::guards_of<Method>::type>()));
    enum class progress { again, accepted, given_up };

    step_loop(const Method& method, Problem& problem, const Vector& y0, const scalar& t0, const scalar& t1,
              const options<scalar>& o, bool keeps_output)
        : start_(sums_over<scalar>(problem)),
          options_(with_break_points_of(problem, o)),
          n_(static_cast<int>(y0.size())),
          system_(problem, y0, report_),
          steps_(steps::make(detail::as_tuple(method), n_)),
          plan_(checked_plan(y0, t0, t1, options_)),
          norm_(options_, system_.raised(), y0, system_.sums()),
          linear_(n_),
          guards_(detail::guards_of<Method>::of(method)),
          judge_(o, t0, detail::guards_in<system_type>(guards_)),
          t_(plan_.begin(t0)),
          y_(y0),
          y1_(n_),
          error_(n_),
          f_(n_),
          outputs_{output_type(n_, detail::largest_columns(steps_)),
                   output_type(n_, detail::largest_columns(steps_))},
          keeps_output_(keeps_output) {
        system_.set_extent(start_.agree(system_.extent(), o, t0, t1, detail::largest_columns(steps_)));
        report_.set_tolerances(o);
        system_.ends_at(plan_.last(), plan_.before_last());
        if (!system_.inside(t0, y0))
            throw std::invalid_argument("integrate: y0 must lie in problem.domain()");
        h_ = plan_.equal().h;
        system_.border().lies_near(y_, norm_.of_state());
        if (std::apply([](auto&... m) { return (m.implicit() || ...); }, steps_)) system_.take_jacobian();
        prepare_methods(steps_, system_, options_, run_demands{plan_.fixed(), keeps_output_, o.jumps},
                        judge_);
    }
    step_loop(const step_loop&) = delete;
    step_loop& operator=(const step_loop&) = delete;

    const refusals<scalar>& refused() const { return attempts_.refused(); }
    template <class F>
    decltype(auto) visit_current(F&& f) {
        return detail::visit_at(steps_, judge_.method(), std::forward<F>(f));
    }
    [[gnu::noinline, gnu::cold]] progress give_up(stagecraft::status s) {
        status_ = cause_of(s, system_, t_, y_, norm_, options_.rtol, report_);
        return progress::given_up;
    }

    /// Behind a break point or a change of y nothing of the steps before is left.
    [[gnu::noinline, gnu::cold]] void begin_afresh() {
        t_ = plan_.begin(t());
        h_ = plan_.equal().h;
        before_ = report_.steps;
        started_ = has_output_ = false;
        norm_.at(y_);
        f_.forget();
        linear_.start();
        extrapolation_ = {};
        judge_.start(options_, t_, detail::guards_in<system_type>(guards_));
        std::apply([](auto&... m) { (m.replaced(), ...); }, steps_);
    }
    /// No step has been accepted since the run began, or went on afresh.
    bool first() const { return report_.steps == before_; }

    /// Evaluates f(t0, y0) where the run needs it and chooses the first step.
    [[gnu::noinline, gnu::cold]] bool start() {
        bool left = false;
        visit_current([&](auto& m) { left = this->needs_left_value(m); });
        const bool choose = !plan_.fixed() && options_.initial_step == scalar(0);
        if (left || choose || has_second_order_components<Problem>) {
            const Vector& f0 = f_.left(system_, t_, y_);
            const scalar size = weighted_norm(f0, norm_.of_state(), n_, norm_.sums());
            if (!(size - size == scalar(0))) return give_up(status::non_finite) == progress::accepted;
            system_.demand_second_order(f0, y_);
        }
        started_ = true;
        if (plan_.fixed()) return true;
        h_ = plan_.first(
            choose ? initial_step(system_, norm_, t_, y_, f_.value(), plan_.end()) : options_.initial_step,
            t_);
        return true;
    }

    /// One attempt at the next step: plan, linearise, solve, judge, and then accept or propose another.
    template <class Step>
    progress attempt(Step& method) {
        planned_step<scalar> plan = plan_.next(t_, h_, report_.steps - before_, refused().all);
        unsolved_before_ = report_.linear_failures;
        if (plan.obstacle != status::success)
            return give_up(plan.obstacle == status::step_underflow ? attempts_.obstacle() : plan.obstacle);
        output_type& now = *tried_;

        const bool begins = needs_left_value(method) && !first() && refused().all == 0;
        if (begins && !starts_inside(method, system_, t_, y_, h_, norm_, has_output_ ? output_ : nullptr, f_))
            return give_up(status::non_finite);
        const linear_state linear = linearise(method, plan.h);
        if (linear == linear_state::forbidden) return refuse_forbidden(plan);
        const newton_outcome<scalar> newton = solve(method, plan.h, linear, now);
        if (newton.end != newton_end::converged) return refuse_unsolved(method, plan, linear, newton);
        method.advance(y_, now, y1_);
        if constexpr (requires { method.part_taken(); })
            plan = plan_.ended_after(plan, t_, method.part_taken());
        const domain_end end =
            look_at_end(system_, plan, y_, y1_, norm_.of_state(), options_, plan_.fixed(), error_);
        if (end == domain_end::not_finite || end == domain_end::outside) return refuse_end(plan, end);
        if (!plan_.fixed()) {
            const verdict<scalar> said = judged(method, plan, newton, now);
            if (!said.accepted) return refuse_error(plan, said);
            h_ = plan_.bounded(said.next_h);
        }
        return accept(method, plan, now, end);
    }
    /// What the judge says of an attempt whose stage equations are solved.
    template <class Step>
    [[gnu::always_inline]] verdict<scalar> judged(Step& method, const planned_step<scalar>& plan,
                                                  const newton_outcome<scalar>& newton,
                                                  const output_type& now) {
        measured_step measured(method, system_, norm_, y_, now, f_, y1_, error_, report_);
        measured.begins(t_, plan, judge_.method(), refused(), first());
        measured.iterations = newton.iterations;
        measured.theta = linear_.theta();
        measured.across_kink = across_kink_;
        if (method.implicit()) measured.hold = linear_.hold();
        if constexpr (!system_type::mass_type::identity) {
            measured.ends = plan.t_next == plan_.end();
            if (watched_.any()) measured.watch(watched_);
        }
        return judge_(measured);
    }

    /// Evaluates what the stages need at the left end, the Jacobian if it is wanted, and factors.
    template <class Step>
    [[gnu::always_inline]] linear_state linearise(Step& method, const scalar& h) {
        using std::abs;
        if (needs_left_value(method)) f_.left(system_, t_, y_);
        norm_.over(h);
        method.begin(f_.value());
        if (!method.implicit()) return linear_state::factored;
        if (linear_.wanted()) {
            const bool ahead =
                extrapolates() && refused().all == 0 && !plan_.fixed() && !system_.border().watched();
            linear_.evaluate(system_, t_, y_, f_.value(), h, has_output_ ? output_ : nullptr, ahead, options_,
                             y1_);
            judge_.linearised();
            if constexpr (!system_type::mass_type::identity)
                if (first() && watched_.any() && !constraints_determine(system_, options_.rtol))
                    watched_.forget();
        }
        const auto slope = [&]() -> const Vector& { return f_.left(system_, t_, y_); };
        if (first() && refused().all == 0 && !method.forgets())
            demand_consistent_start(system_, slope, norm_.of_state(), scalar(plan_.fixed() ? 1000 : 10));
        const scalar last = extrapolates() ? output_->step() : scalar(0);
        const factored_step tried{system_, method.stages(), slope, norm_, h, 2 * abs(h) > 3 * abs(last)};
        return linear_.factor(
            system_, method.stages(), h, judge_.method(),
            [&] { return !plan_.fixed() && judge_.forbids(tried); }, report_.factorisations);
    }

    /// Solves the stage equations by Newton's iteration from the extrapolated solution; those of a fixed
    /// step, which cannot be repeated with a smaller one, by homotopy where that fails; stage by stage where the rate
    /// is that of a kink. (In fixed steps by methods that forget: others would go on with what a step leaves.)
    template <class Step>
    [[gnu::always_inline]] newton_outcome<scalar> solve(Step& method, const scalar& h, linear_state linear,
                                                        output_type& now) {
        newton_outcome<scalar> newton;
        newton_limits<scalar> limits{};
        across_kink_ = false;
        if (method.iterates()) {
            const bool affine =
                !first() && linear_.constant(system_) && linear_.factored_within(h, options_.rtol / 100);
            limits = newton_room(options_, method.coupled_stages_count(), system_.largest_index(),
                                 system_type::mass_type::identity, refused().by_newton, affine);
        }
        if (linear == linear_state::factored) {
            newton = solve_from_guess(method, system_, extrapolates() ? output_ : nullptr, t_, y_, h, norm_,
                                      limits, now, report_.solves);
        }
        if (plan_.fixed() && linear_.fresh() && newton.end != newton_end::converged)
            if (solve_by_homotopy(method, system_, t_, y_, h, norm_, limits, now, report_, newton))
                linear_.factored_for(h, judge_.method());
        if constexpr (meets_kinks<Step, system_type>)
            if (newton.end == newton_end::diverged && linear == linear_state::factored && linear_.fresh())
                if (plan_.fixed() ? method.forgets()
                                  : meets_a_kink(newton.theta, attempts_.theta_of_longer(h),
                                                 refused().by_newton, attempts_.in_a_row())) [[unlikely]] {
                    const newton_outcome<scalar> led =
                        solve_across_kink(method, system_, extrapolates() ? output_ : nullptr, t_, y_, h,
                                          norm_, limits, now, report_);
                    across_kink_ = led.end == newton_end::converged;
                    if (across_kink_) newton = led;
                    linear_.tried_elsewhere(across_kink_, h, judge_.method());
                }
        if (newton.end == newton_end::converged && method.iterates())
            linear_.solved(newton, factorisation_cost(method, system_), first());
        return newton;
    }

    /// A step of h is to be tried in place of the planned one, if t resolves it.
    progress shorten(const planned_step<scalar>& plan, const scalar& h) {
        if (!plan_.fixed() && attempts_.may_be_of_the_start(first()) && moves_start(plan.h))
            return progress::again;
        if (plan.smallest) return give_up(attempts_.obstacle());
        h_ = h;
        return progress::again;
    }

    /// The state moves to the constraints, where they can be satisfied. The method of a run that is here forgets where a step
    /// begins, which is in no stage of it.
    bool moves_start(const scalar& h) {
        error_ = y_;
        return visit_current([&](auto& m) {
            if (!move_start(m, system_, linear_, t_, y_, h, norm_, f_, options_, report_)) return false;
            if (has_output_) output_->move_end(y_ - error_);
            m.replaced();
            return true;
        });
    }

    /// A guard forbids the step.
    [[gnu::noinline, gnu::cold]] progress refuse_forbidden(const planned_step<scalar>& plan) {
        attempts_.forbidden(report_);
        return linear_.stay_behind() ? progress::again : shorten(plan, plan.h / 4);
    }

    /// The stage equations could not be solved: the cheapest change that may help (judge/unsolved.hpp), and again.
    template <class Step>
    [[gnu::noinline, gnu::cold]] progress refuse_unsolved(Step& method, const planned_step<scalar>& plan,
                                                          linear_state linear,
                                                          const newton_outcome<scalar>& newton) {
        const bool singular = linear == linear_state::singular, finite = newton.end != newton_end::non_finite;
        const unsolved_attempt failed{
            .singular = singular,
            .finite_data =
                !singular || (all_finite(f_.value(), n_, system_.sums()) && system_.finite_jacobian()),
            .finite_stages = finite,
            .unsolved_linear = !finite && linear_solver_failed(),
            .fixed = plan_.fixed(),
            .old_jacobian = method.implicit() && linear_.may_be_renewed(system_),
            .new_border = !finite && !distributed && !system_.border().watched(),
            .noisy_guess = system_.rough_stages() && extrapolates()};
        attempts_.unsolved(why_unsolved(failed), report_);
        switch (remedy_for(failed)) {
            case remedy::continued_f:
                system_.border().watch();
                return progress::again;
            case remedy::new_jacobian:
                linear_.renew(system_);
                return progress::again;
            case remedy::constant_guess:
                linear_.stay_behind();
                extrapolation_.failed();
                return progress::again;
            case remedy::shorter_step:
                linear_.stay_behind();
                attempts_.shortened(plan.h, newton.theta);
                judge_.unsolved(refused().all >
                                (system_.rough_stages() ? 2 : 1));  // one of two from a constant
                return shorten(plan, plan.h / 2);
            case remedy::none:
                break;
        }
        return give_up(attempts_.obstacle());
    }

    /// The stage equations are solved, but the step is to be another one.
    progress repeat(const planned_step<scalar>& plan, const scalar& h) {
        f_.retry();
        linear_.rejected(system_);
        return shorten(plan, h);
    }

    /// The run cannot go on from where the step would end: half of it, as after stage equations that could not be solved.
    [[gnu::noinline, gnu::cold]] progress refuse_end(const planned_step<scalar>& plan, domain_end end) {
        if (end == domain_end::outside)
            attempts_.outside(report_);
        else
            attempts_.not_finite(status::non_finite, report_);
        if (plan_.fixed()) return give_up(attempts_.obstacle());
        return repeat(plan, plan.h / 2);
    }

    /// The error is too large, or not finite.
    [[gnu::noinline, gnu::cold]] progress refuse_error(const planned_step<scalar>& plan,
                                                       const verdict<scalar>& said) {
        if (said.error - said.error == scalar(0))
            attempts_.too_large(plan.h, said.error, report_);
        else
            attempts_.not_finite(linear_solver_failed() ? status::linear_solver_failed : status::non_finite,
                                 report_);
        return repeat(plan, said.next_h);
    }

    /// In this attempt, on some process. It leaves NaN.
    bool linear_solver_failed() const {
        scalar unsolved(report_.linear_failures > unsolved_before_ ? 1 : 0);
        system_.sums()(&unsolved, 1);
        return unsolved > scalar(0);
    }

    /// Moves to the end of the step.
    template <class Step>
    [[gnu::always_inline]] progress accept(Step& method, const planned_step<scalar>& plan, output_type& now,
                                           domain_end end) {
        using std::abs;
        if (!system_.finite(y1_)) return give_up(status::non_finite);
        has_output_ = complete_step(method, system_, plan, end, options_, t_, y_, y1_, f_, keeps_output_, now,
                                    error_, report_);
        method.accepted();
        f_.stepped();
        extrapolation_.stepped();
        if constexpr (meets_kinks<Step, system_type>)
            if (across_kink_) extrapolation_.failed();
        linear_.stepped(system_);
        report_.count_step(abs(plan.h), method.count());
        std::swap(output_, tried_);
        t_ = plan.t_next;
        y_ = y1_;
        norm_.at(y_);
        return progress::accepted;
    }

    template <class Step>
    bool needs_left_value(const Step& method) const {
        return method.needs_left_value(plan_.fixed()) || (method.implicit() && linear_.needs_left_value());
    }

    /// The polynomial of the last step is to start the iteration.
    bool extrapolates() const {
        return has_output_ && extrapolation_.trusted() && (system_.rough_stages() || refused().all < 2);
    }

    [[no_unique_address]] joint_start<scalar, typename system_type::sums_type> start_;
    options<scalar> options_;
    int n_;
    report<scalar> report_{};
    system_type system_;
    typename steps::type steps_;
    step_plan<scalar> plan_;
    norm_type norm_;
    linearisation<system_type, Vector> linear_;
    [[no_unique_address]] typename detail::guards_of<Method>::type guards_;  // as judges begin with them
    judge<scalar, method_count<Method>, guards_type> judge_;
    extrapolation_trust extrapolation_;
    scalar t_, h_{0};
    Vector y_, y1_, error_;
    end_slope<Vector> f_;
    [[no_unique_address]] watched_components_of<system_type, Vector> watched_;
    std::array<output_type, 2> outputs_;  // of the step accepted last, and of the one that is tried
    output_type *output_ = &outputs_[0], *tried_ = &outputs_[1];
    long before_ = 0;           // report_.steps when the run began, or went on afresh
    long unsolved_before_ = 0;  // report_.linear_failures before this attempt
    attempts<scalar> attempts_;
    bool keeps_output_, started_ = false, has_output_ = false;
    bool across_kink_ = false;  // the present attempt leads there
    stagecraft::status status_ = status::success;
};

}  // namespace stagecraft
