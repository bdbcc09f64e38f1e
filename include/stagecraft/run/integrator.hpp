// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <exception>
#include <stdexcept>

#include <stagecraft/run/make_consistent.hpp>
#include <stagecraft/run/step_loop.hpp>

namespace stagecraft {

/// A run that is advanced step by step: while (run.step()) use run.t(), run.y(), run.output().
/// Construction takes the arguments of integrate(), checks every one (std::invalid_argument names the bad
/// one) and takes all storage; a step allocates nothing after the first. Without `keeps_output` the methods
/// that do not need output() themselves leave it empty but for step(). What a callable throws passes through
/// step(), with t() and y() at the last accepted state; calling step() again tries the step again.
template <class Method, class Problem, class Vector>
class integrator : public step_loop<Method, Problem, Vector> {
    using loop = step_loop<Method, Problem, Vector>;
    using loop::attempts_, loop::f_, loop::h_, loop::n_, loop::t_, loop::y_, loop::before_,
        loop::extrapolation_, loop::has_output_, loop::judge_, loop::linear_, loop::norm_, loop::options_,
        loop::output_, loop::plan_, loop::report_, loop::started_, loop::status_, loop::steps_, loop::system_,
        loop::watched_;
    using typename loop::system_type;

  public:
    using typename loop::output_type;
    using typename loop::scalar;
    static_assert(detail::fit_in_parts<Method, Problem>,
                  "an additive method and a problem split(f_explicit, f_implicit) belong together: neither "
                  "runs without the other");

    integrator(const Method& method, Problem& problem, const Vector& y0, const scalar& t0, const scalar& t1,
               const options<scalar>& o, bool keeps_output = true)
        : loop(method, problem, y0, t0, t1, o, keeps_output) {}

    /// The last accepted state, at t(); y0 before the first.
    const Vector& y() const { return y_; }
    /// The continuous solution over the last accepted step; there is none before the first.
    const output_type& output() const { return *output_; }
    const options<scalar>& given_options() const { return options_; }
    /// The report so far.
    const report<scalar>& counts() const { return report_; }
    /// success as long as nothing has ended the run.
    stagecraft::status status() const { return status_; }
    /// Ends the run here: status::stopped.
    void stop() { status_ = status::stopped; }
    /// Somebody will look between the ends of the steps: algebraic components are controlled there too.
    void watch_between_ends() {
        if constexpr (!system_type::mass_type::identity)
            if (!plan_.fixed()) watched_.find(system_);
    }
    /// Does what `watch` does between two steps; where that returns false the run ends here. In a distributed run
    /// all processes call it together, and all of them end where one does; an exception leaves on its own process
    /// and is status::non_finite on the others.
    template <class F>
    void between_steps(F&& watch) {
        const consent all = consent_of_all<scalar>(system_.sums(), watch);
        if (all == consent::thrown) this->give_up(status::non_finite);
        if (all == consent::stop) stop();
    }
    /// Goes on from `y` in place of y() (a projection, say), both of about the accuracy asked for. The
    /// continuous solution of the last step is bent to end there, the next step starts there in every
    /// respect. std::invalid_argument where y is not finite or of another size.
    void replace_state(const Vector& y) {
        validate_corrected(y, n_, system_.sums());
        if (has_output_) output_->move_end(y - y_);
        y_ = y;
        norm_.at(y_);
        f_.forget();
        this->visit_current([](auto& m) { m.replaced(); });
    }

    /// Goes back to t, within the last step or at its end, and on from y there, finite and of the same size, as a run that
    /// begins: a dose, a reset.
    void restart(const scalar& t, const Vector& y) {
        t_ = t;
        y_ = y;
        plan_.go_on_afresh();
    }

    /// Where options.consistent_start asks for it, y() moves to where the equations without a derivative hold, before the
    /// next step is made. A run in which they cannot be made to hold is status::inconsistent_start.
    void make_consistent() {
        if constexpr (!system_type::mass_type::identity)
            if (options_.consistent_start && !this->finished()) move_to_constraints();
    }

    bool inside(const scalar& t, const Vector& y) const { return system_.inside(t, y); }

    /// All that the next step depends on, into or out of a checkpoint of t() and y() (checkpoint.hpp).
    template <class Bag>
    void carry(Bag& bag) {
        if (plan_.afresh(t_)) plan_.go_on_afresh();
        std::apply([&](auto&... m) { (bag.same_method(m.method(), m.order()), ...); }, steps_);
        bag(h_, started_, has_output_, before_, report_, plan_, judge_, linear_, extrapolation_, attempts_,
            f_, system_);
        std::apply([&](auto&... m) { bag(m...); }, steps_);
        if (has_output_) bag(*output_);
        if constexpr (Bag::unpacks)
            linear_.factor_again([&](int k, const scalar& h) {
                detail::visit_at(steps_, k, [&](auto& m) { m.stages().factor(system_, h); });
            });
    }

    /// What more there is to say of status(), as an exception: of status::constraints_dependent, which; null where nothing is.
    std::exception_ptr reason() requires(names_dependent_constraints<Problem, scalar, Vector>) {
        if (this->status() == status::constraints_dependent)
            return std::make_exception_ptr(std::domain_error(
                "integrate: near result.t, result.y " + system_.problem().dependent_constraints(t_, y_)));
        return nullptr;
    }

  private:
    [[gnu::noinline, gnu::cold]] void move_to_constraints() {
        if (plan_.afresh(t_)) this->begin_afresh();
        if (!this->start()) return;
        const bool found = this->visit_current([&](auto& m) {
            return stagecraft::make_consistent(m, system_, linear_, t_, y_, h_, norm_, options_, report_);
        });
        if (!found) this->give_up(status::newton_failed);
        if (!system_.inside(t_, y_))
            throw std::invalid_argument("integrate: consistent_start leads out of problem.domain()");
        norm_.at(y_);
        f_.forget();
        started_ = false;
    }

  public:
    /// The number of the method that has made the last accepted step.
    int last_method() const { return linear_.factored_method(); }
    /// f(method) with the method of the last accepted step, whose matrices are factored for that step.
    template <class F>
    decltype(auto) visit_last(F&& f) {
        return detail::visit_at(steps_, last_method(), std::forward<F>(f));
    }
};

}  // namespace stagecraft
