// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <stagecraft/control/equal_steps.hpp>
#include <stagecraft/control/first_step.hpp>
#include <stagecraft/control/options.hpp>
#include <stagecraft/control/order.hpp>
#include <stagecraft/control/step_size.hpp>
#include <stagecraft/jumps/smoothness.hpp>
#include <stagecraft/linear/norms.hpp>
#include <stagecraft/problem/system.hpp>
#include <stagecraft/report.hpp>
#include <stagecraft/stages/growth.hpp>
#include <stagecraft/status.hpp>
#include <stagecraft/step/continuation.hpp>
#include <stagecraft/step/method_set.hpp>

namespace stagecraft {

/// A run that is advanced step by step: while (run.step()) use run.t(), run.y(), run.output().
/// Construction takes the arguments of integrate(), checks every one (std::invalid_argument names the bad
/// one) and takes all storage; a step allocates nothing after the first. Without `keeps_output` the methods
/// that do not need output() themselves leave it empty but for step(). What a callable throws passes through
/// step(), with t() and y() at the last accepted state; calling step() again tries the step again.
template <class Method, class Problem, class Vector>
class integrator {
  public:
    using scalar = typename Vector::Scalar;
    using steps = detail::steps_of<std::decay_t<decltype(detail::as_tuple(std::declval<const Method&>()))>,
                                   Vector::RowsAtCompileTime, typename system<Problem, Vector>::blocks>;
    using output_type = dense_output<Vector, steps::max_stages>;
    static_assert(std::is_same_v<scalar, typename steps::scalar>,
                  "method and state must have the same scalar type");

    integrator(const Method& method, Problem& problem, const Vector& y0, const scalar& t0, const scalar& t1,
               const options<scalar>& o, bool keeps_output = true)
        : options_(o),
          n_(static_cast<int>(y0.size())),
          system_(problem, y0, report_),
          steps_(steps::make(detail::as_tuple(method), n_)),
          t_(t0),
          t1_(t1),
          direction_(t1 < t0 ? -1 : 1),
          y_(y0),
          y1_(n_),
          f0_(n_),
          error_(n_),
          scale_(n_),
          weights_(n_),
          negligible_(n_),
          outputs_{output_type(n_, largest_columns()), output_type(n_, largest_columns())},
          keeps_output_(keeps_output) {
        validate(o, n_);
        validate_interval(y0, t0, t1);
        report_.set_tolerances(o);
        f0_.setZero();
        set_weights(options_, y_, scale_);
        if (o.fixed_step > scalar(0)) {
            plan_ = plan_equal_steps(t0, t1, o.fixed_step);
            h_ = plan_.h;
        }
        if (std::apply([](auto&... m) { return (m.implicit() || ...); }, steps_)) system_.take_jacobian();
        for (int k = 0; k < method_count<Method>; ++k) prepare_method(k);
    }
    integrator(const integrator&) = delete;
    integrator& operator=(const integrator&) = delete;

    /// Where the run is: the last accepted state, t0 and y0 before the first.
    const scalar& t() const { return t_; }
    const Vector& y() const { return y_; }
    /// The continuous solution over the last accepted step; there is none before the first.
    const output_type& output() const { return outputs_[current_]; }
    /// The report so far.
    const report<scalar>& counts() const { return report_; }
    /// success as long as nothing has ended the run.
    stagecraft::status status() const { return status_; }
    bool finished() const { return t_ == t1_ || status_ != status::success; }
    /// Ends the run here: status::stopped.
    void stop() { status_ = status::stopped; }
    /// Goes on from `y` in place of y() (a projection, say), both of about the accuracy asked for. The
    /// continuous solution of the last step is bent to end there, the next step starts there in every
    /// respect. std::invalid_argument where y is not finite or of another size.
    void replace_state(const Vector& y) {
        if (y.size() != n_ || !all_finite(y, n_))
            throw std::invalid_argument("integrate: the corrected state must be finite and of the same size");
        if (has_output_) outputs_[current_].move_end(y - y_);
        y_ = y;
        set_weights(options_, y_, scale_);
        left_value_known_ = false;
        visit_current([](auto& m) { m.replaced(); });
    }

    /// Takes one accepted step; false if there is none to take (t1 reached) or none could be taken
    /// (status()).
    bool step() {
        if (finished()) return false;
        if (!started_ && !start()) return false;
        failures_ = 0;
        obstacle_ = status::step_underflow;
        for (;;) {
            const attempt_end ended = visit_current([this](auto& method) { return this->attempt(method); });
            if (ended != attempt_end::change_method) return ended == attempt_end::accepted;
        }
    }

  private:
    enum class attempt_end { accepted, given_up, change_method };
    static constexpr bool variable = method_count<Method> > 1;

    template <class F>
    decltype(auto) visit_current(F&& f) {
        return detail::visit_at(steps_, order_.current(), std::forward<F>(f));
    }
    int largest_columns() {
        int most = 0;
        std::apply([&](auto&... m) { ((most = m.columns() > most ? m.columns() : most), ...); }, steps_);
        return most;
    }
    bool fixed() const { return plan_.count > 0; }
    attempt_end end(stagecraft::status s) {
        status_ = s;
        return attempt_end::given_up;
    }

    void prepare_method(int k) {
        detail::visit_at(steps_, k, [&](auto& m) {
            m.prepare(system_, fixed(), keeps_output_);
            if (!fixed() && system_.largest_index() > 2 && !m.stiffly_accurate())
                throw std::invalid_argument(
                    "integrate: method must be stiffly accurate for problem.index() 3, where the errors of "
                    "others have no bound; use options.fixed_step");
            if (options_.continuous && !fixed() && !m.knows_output_error())
                throw std::invalid_argument(
                    "integrate: continuous needs a transformed_tableau of two stages at least, other than "
                    "Radau IA");
            ratio_[k] = m.estimate_ratio(options_.rtol);
            if (variable || options_.continuous) m.prepare_decay();
            if constexpr (variable)
                order_.prepare(k, {m.count(), m.estimate_power(), ratio_[k], m.stages().work(system_)},
                               options_.rtol);
        });
    }

    scalar norm(const Vector& x, const Vector& w) const { return weighted_norm(x, w, n_); }

    /// Evaluates f(t0, y0) where the run needs it and chooses the first step.
    bool start() {
        using std::abs;
        bool left = false;
        visit_current([&](auto& m) { left = this->needs_left_value(m); });
        if (left || (!fixed() && options_.initial_step == scalar(0)) ||
            has_second_order_components<Problem>) {
            system_(t_, y_, f0_);
            left_value_known_ = true;
            const scalar size = norm(f0_, scale_);
            if (!(size - size == scalar(0))) return end(status::non_finite) == attempt_end::accepted;
            if constexpr (has_second_order_components<Problem>)
                for (int i = 0, m = position_components<Problem>(n_); i < m; ++i)
                    if (!(f0_[i] == y_[m + i]))
                        throw bad_problem(
                            "integrate: problem.second_order_components does not hold: f_i is not y_{m+i}");
        }
        started_ = true;
        if (fixed()) return true;
        const scalar span = abs(t1_ - t_);
        h_ = options_.initial_step > scalar(0) ? options_.initial_step
                                               : first_step(system_.mass(), y_, f0_, scale_, span);
        if (h_ > span) h_ = span;
        if (options_.max_step > scalar(0) && h_ > options_.max_step) h_ = options_.max_step;
        if (h_ < options_.min_step) h_ = options_.min_step;
        h_ *= scalar(direction_);
        return true;
    }

    template <class Step>
    attempt_end attempt(Step& method);
    template <class Step>
    attempt_end accept(Step& method, const scalar& h, const scalar& t_next, output_type& now);
    template <class Step>
    scalar error_of(Step& method, const scalar& h, const scalar& t_next, output_type& now);
    template <class Step>
    void propose(Step& method, const scalar& h, scalar err);

    /// f at the end of the attempt takes the place of that at its beginning.
    void evaluate_right(const scalar& t_next) {
        left_value_known_ = false;
        system_(t_next, y1_, f0_);
        right_value_known_ = true;
    }

    template <class Step>
    bool needs_left_value(const Step& method) const {
        return method.needs_left_value(fixed()) ||
               (system_type::finite_difference && method.implicit() && want_jacobian_);
    }

    /// True if the polynomial of the last step is to start the iteration.
    bool extrapolates() const {
        return has_output_ && (system_.largest_index() > 1 ? extrapolation_.trusted() : failures_ < 2);
    }

    /// A fixed step cannot be repeated with a smaller one, so its iteration is given more room.
    newton_limits<scalar> newton_limits_for(int s) {
        const scalar rounding = std::numeric_limits<scalar>::epsilon() / options_.rtol;
        const int most = options_.newton_iterations > 0 ? options_.newton_iterations
                         : fixed()                      ? 50
                                                        : usual_iterations(s);
        return {options_.newton_factor > scalar(0) ? options_.newton_factor : scalar(1) / 50, 4 * rounding,
                100 * rounding, most, report_.steps > 0 && constant_jacobian()};
    }

    /// The problem says so, and the first step did not show otherwise.
    bool constant_jacobian() { return !contradicted_ && system_.constant_jacobian(); }
    /// With a constant Jacobian Newton's second increment is what rounding, or differences, leave of the
    /// first. Where it is not, the claim is not believed: one iteration a step would leave errors that
    /// nothing sees.
    void judge_constant_jacobian(const scalar& theta) {
        using std::sqrt;
        const scalar exact = system_type::finite_difference
                                 ? scalar(1) / 1000000
                                 : scalar(sqrt(std::numeric_limits<scalar>::epsilon()));
        contradicted_ = contradicted_ || theta > exact;
    }

    void refresh_jacobian(const scalar& h) {
        using std::abs;
        if constexpr (system_type::finite_difference) {
            for (int i = 0; i < n_; ++i) {
                const scalar moved = abs(h * f0_[i]),
                             small = absolute_tolerance(options_, i) / options_.rtol / 1000;
                negligible_[i] = moved > small ? moved : small;
            }
        }
        ahead_ = !system_type::finite_difference && extrapolates() && failures_ == 0 && !fixed();
        if (ahead_) {
            // Two fifths into the step the Jacobian serves all stages best; not further than the last step
            // was long, as that is where the state comes from. (Differences need f there as well: they stay
            // at the left end, where it is known.)
            const scalar last = outputs_[current_].step();
            const scalar ahead = (abs(h) < abs(last) ? h : last) * 2 / 5;
            outputs_[current_].evaluate(t_ + ahead, y1_);
            system_.evaluate_jacobian(t_ + ahead, y1_, f0_, negligible_);
        } else {
            system_.evaluate_jacobian(t_, y_, f0_, negligible_);
        }
        fresh_jacobian_ = true;
        want_jacobian_ = false;
        factored_ = false;
    }

    using system_type = stagecraft::system<Problem, Vector>;

    options<scalar> options_;
    int n_;
    report<scalar> report_{};
    system_type system_;
    typename steps::type steps_;
    equal_steps<scalar> plan_;
    scalar t_, t1_;
    int direction_;
    Vector y_, y1_, f0_, error_, scale_, weights_, negligible_;
    std::array<output_type, 2> outputs_;
    int current_ = 0;
    std::array<scalar, static_cast<std::size_t>(method_count<Method>)> ratio_{};
    step_size_controller<scalar> controller_{options_.control};
    order_controller<scalar, method_count<Method>> order_{};
    extrapolation_trust extrapolation_;
    smoothness<scalar> smooth_;
    growth_watch<scalar> growth_;
    scalar h_{0}, factored_h_{0}, theta_{0};
    int factored_order_ = 0, iterations_ = 0, failures_ = 0;
    long attempts_ = 0;
    bool keeps_output_, started_ = false, has_output_ = false, factored_ = false, want_jacobian_ = true,
                        fresh_jacobian_ = false, ahead_ = false, last_was_rejected_ = false,
                        rejected_by_estimate_ = false, left_value_known_ = false, right_value_known_ = false,
                        contradicted_ = false;
    stagecraft::status status_ = status::success, obstacle_ = status::step_underflow;
};

}  // namespace stagecraft

#include <stagecraft/step/attempt.hpp>
