// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <stagecraft/step/integrator.hpp>

// How the integrator makes a step: attempt, error estimate, acceptance, proposal of the next one.

namespace stagecraft {

/// Attempts until a step is accepted or none can be.
template <class Method, class Problem, class Vector>
template <class Step>
auto integrator<Method, Problem, Vector>::attempt(Step& method) -> attempt_end {
    using std::abs;
    const scalar eps = std::numeric_limits<scalar>::epsilon();
    const int s = method.coupled_stages_count();
    const bool implicit = method.implicit();
    for (;;) {
        if (attempts_++ >= options_.max_steps) return end(status::too_many_steps);
        scalar h = h_, t_next = t_;
        if (fixed()) {
            t_next = plan_.end(report_.steps + 1);
            if (t_next == t1_) h = not_beyond(t_, h, t1_);
        } else {
            const scalar rest = t1_ - t_;
            if (abs(h) * (scalar(1) + scalar(1) / 100000) >= abs(rest)) {
                h = not_beyond(t_, rest, t1_);
                t_next = t1_;
            } else {
                if (abs(h) * 2 > abs(rest)) h = rest / 2;
                t_next = t_ + h;
            }
            if (failures_ > 60 || abs(h) <= scalar(10) * eps * abs(t_) || t_next == t_ ||
                abs(h_) < options_.min_step)
                return end(obstacle_);
        }
        if (needs_left_value(method) && !left_value_known_) {
            system_(t_, y_, f0_);
            left_value_known_ = true;
        }
        output_type& now = outputs_[1 - current_];
        weights_ = scale_;
        system_.weigh_by_index(weights_, h, options_.rtol);

        if (implicit && want_jacobian_) refresh_jacobian(h);
        if (!implicit) {
            factored_ = true;
        } else if (!factored_ || factored_h_ != h || factored_order_ != order_.current()) {
            ++report_.factorisations;
            factored_ = method.stages().factor(system_, h);
            factored_h_ = h;
            factored_order_ = order_.current();
            if (factored_ && !fixed() && growth_.sees(system_, method.stages())) {
                factored_ = false;
                obstacle_ = status::step_underflow;
                ++report_.rejected_error;
                ++failures_;
                last_was_rejected_ = true;
                want_jacobian_ = ahead_;
                if (!ahead_) h_ = h / 4;
                continue;
            }
        }
        newton_outcome<scalar> newton;
        method.begin(f0_);
        if (factored_) {
            method.guess(extrapolates() ? &outputs_[current_] : nullptr, y_, h, now);
            newton = method.stages().solve(system_, t_, y_, h, weights_, newton_limits_for(s),
                                           now.increments(), report_.solves);
        }
        if (fixed() && fresh_jacobian_ && newton.end != newton_end::converged)
            factored_ |= solve_by_continuation(method, system_, t_, y_, h, weights_, newton_limits_for(s),
                                               now, report_, newton);
        if (!factored_ || newton.end != newton_end::converged) {
            const bool left_is_finite = all_finite(f0_, n_);
            obstacle_ = !factored_ && left_is_finite           ? status::singular_matrix
                        : !factored_                           ? status::non_finite
                        : newton.end == newton_end::non_finite ? status::non_finite
                                                               : status::newton_failed;
            ++report_.rejected_newton;
            ++failures_;
            last_was_rejected_ = true;
            if (implicit && !fresh_jacobian_ && !constant_jacobian()) {
                want_jacobian_ = true;
                continue;
            }
            if (fixed()) return end(obstacle_);
            want_jacobian_ = ahead_;  // where the extrapolation went astray the Jacobian did
            if (system_.largest_index() > 1 && extrapolates()) {
                extrapolation_.failed();
                continue;
            }
            h_ = h / 2;
            if constexpr (variable)
                if (failures_ > 1 && order_.newton_failed()) return attempt_end::change_method;
            continue;
        }
        if (report_.steps == 0) judge_constant_jacobian(newton.theta);
        iterations_ = newton.iterations;
        if (newton.theta > scalar(0)) theta_ = newton.theta;

        method.advance(y_, now, y1_);
        if (fixed()) return accept(method, h, t_next, now);

        scalar err = error_of(method, h, t_next, now);
        if (options_.continuous) {
            const scalar between = method.output_error(now, weights_);
            if (err < between) err = between;
        }
        if (err < scalar(1)) {
            propose(method, h, err);
            return accept(method, h, t_next, now);
        }
        ++failures_;
        last_was_rejected_ = true;
        right_value_known_ = false;
        if (!(err - err == scalar(0))) {
            obstacle_ = status::non_finite;
            ++report_.rejected_newton;
            h_ = h / 8;
        } else {
            obstacle_ = status::step_underflow;
            ++report_.rejected_error;
            rejected_by_estimate_ = true;
            h_ = report_.steps == 0 ? scalar(h / 10)
                                    : scalar(h * controller_.after_rejected(err, method.estimate_power(),
                                                                            scalar(9) / scalar(10)));
        }
        if (!fresh_jacobian_ && theta_ > scalar(1) / 1000) want_jacobian_ = !constant_jacobian();
    }
}

/// Size of the error of the attempt by its estimate, tolerance 1. Where f is evaluated at the end of the step
/// for it, f0_ holds that value (right_value_known_).
template <class Method, class Problem, class Vector>
template <class Step>
auto integrator<Method, Problem, Vector>::error_of(Step& method, const scalar& h, const scalar& t_next,
                                                   output_type& now) -> scalar {
    using std::abs;
    // In steps so small nothing is gained by looking for more than the estimate shows.
    const bool room =
        abs(h) > 4 * options_.min_step && abs(h) > std::numeric_limits<scalar>::epsilon() * 1000000 * abs(t_);
    const scalar smooth_ratio = ratio_[order_.current()],
                 jump_ratio = room ? method.jump_ratio(smooth_ratio) : scalar(1);
    scalar ratio = smooth_.doubted() ? jump_ratio : smooth_ratio;
    const auto size = [this](const Vector& x, bool reduced) {
        return norm(x, reduced ? system_.weights_to_follow(weights_) : weights_);
    };
    const auto error_size = [&] {
        return method.error_size(system_, now, ratio, error_, report_.error_solves, size);
    };
    report_.error_solves += method.estimate(system_, h, f0_, now, error_);
    scalar err = error_size();
    if (err >= scalar(1) && (report_.steps == 0 || last_was_rejected_)) {
        report_.error_solves += method.estimate_again(system_, t_, y_, h, now, y1_, error_);
        method.advance(y_, now, y1_);
        err = error_size();
    }
    if (err < scalar(1) && method.needs_right_value()) {
        evaluate_right(t_next);
        if (const int solves = method.estimate_right(system_, h, f0_, now, error_)) {
            report_.error_solves += solves;
            const scalar right = norm(error_, weights_) * method.right_ratio(ratio);
            if (!(right <= err)) err = right;
        }
    }
    if (smooth_ratio < jump_ratio && report_.steps > 0 &&
        smooth_.surprised(
            err, [&] { return controller_.expected(h, method.estimate_power()); }, rejected_by_estimate_)) {
        controller_.forget();
        ratio = jump_ratio;
        const scalar whole = error_size();
        if (!(whole <= err)) err = whole;
    }
    return room ? method.judge_jump(system_, h, err, error_, report_.error_solves, size) : err;
}

/// Moves to the end of the step and decides whether the Jacobian still serves.
template <class Method, class Problem, class Vector>
template <class Step>
auto integrator<Method, Problem, Vector>::accept(Step& method, const scalar& h, const scalar& t_next,
                                                 output_type& now) -> attempt_end {
    using std::abs;
    if (!all_finite(y1_, n_)) return end(status::non_finite);
    if (method.ends_with_value()) {
        if (!right_value_known_) evaluate_right(t_next);
        if (all_finite(f0_, n_))
            method.end(f0_);
        else
            method.end_without_value(h, y_, y1_);
    }
    has_output_ = keeps_output_ || method.implicit();
    if (has_output_) {
        method.finish(t_, y_, h, y1_, now);
    } else {
        now.cover(t_, h);
    }
    method.accepted();
    current_ = 1 - current_;
    t_ = t_next;
    y_ = y1_;
    left_value_known_ = right_value_known_;
    right_value_known_ = false;
    report_.count_step(abs(h), method.count());
    last_was_rejected_ = false;
    rejected_by_estimate_ = false;
    extrapolation_.stepped();
    fresh_jacobian_ = false;
    set_weights(options_, y_, scale_);
    if (t_ == t1_) return attempt_end::accepted;
    want_jacobian_ = theta_ > scalar(1) / 1000 && !constant_jacobian();
    return attempt_end::accepted;
}

/// The size (and the order) of the next step after one with error err < 1.
template <class Method, class Problem, class Vector>
template <class Step>
void integrator<Method, Problem, Vector>::propose(Step& method, const scalar& h, scalar err) {
    using std::abs;
    if (smooth_.accepted()) {
        controller_.forget();
        const scalar smooth_ratio = ratio_[order_.current()];
        if (smooth_ratio < scalar(1)) err *= smooth_ratio;
    }
    const int most = usual_iterations(method.coupled_stages_count());
    const scalar safety = scalar(9) / scalar(10) * scalar(2 * most + 1) / scalar(2 * most + iterations_);
    scalar factor = controller_.after_accepted(h, err, method.estimate_power(), safety);
    if (last_was_rejected_ && factor > scalar(1)) factor = scalar(1);
    if constexpr (variable) {
        if (order_.wants_evidence() && !last_was_rejected_ && !smooth_.doubted()) {
            const scalar decay = method.decay(outputs_[1 - current_], weights_);
            const scalar change = order_.decide({h, err, decay, theta_, iterations_});
            if (change > scalar(0)) {
                factor = change;
                controller_.forget();
            }
        }
    }
    // Keep the factors while the gain from a new step size is small.
    if (method.implicit() && theta_ <= scalar(1) / 1000 && factor >= scalar(1) && factor <= scalar(6) / 5)
        factor = scalar(1);
    h_ = h * factor;
    if (options_.max_step > scalar(0) && abs(h_) > options_.max_step)
        h_ = options_.max_step * scalar(direction_);
}

}  // namespace stagecraft
