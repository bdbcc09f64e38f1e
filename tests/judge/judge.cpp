// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE judge
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <tuple>
#include <vector>

#include <stagecraft/judge/judge.hpp>
#include <stagecraft/judge/unsolved.hpp>
#include <stagecraft/run/across_kink.hpp>
#include <stagecraft/run/attempts.hpp>
#include <stagecraft/run/newton_room.hpp>
#include <stagecraft/run/step_plan.hpp>
#include <stagecraft/stages/newton.hpp>

#include "attempt.hpp"

// The decisions about steps on plain numbers: acceptance, step size, order, the plan of a run, Newton's iteration.

namespace sc = stagecraft;

namespace {

const auto near = boost::test_tools::tolerance(1e-3);  // of inverse_root

using bare_judge = sc::judge<double, 1, std::tuple<>>;

attempt step_of(double left) {
    attempt step;
    step.h = 0.1;
    step.power = 4;
    step.left = left;
    step.iterations = 1;
    return step;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_error_below_one_is_accepted_and_the_step_grows_by_its_root) {
    bare_judge judge({}, 0.0, {});
    judge.prepare(0, 1.0);
    attempt step = step_of(1.0 / 16);
    const auto said = judge(step);
    BOOST_TEST(said.accepted);
    BOOST_TEST(said.error == 1.0 / 16);
    BOOST_TEST(said.next_h == 0.1 * 2 * 0.9, near);
    BOOST_TEST(judge.last().h == 0.1);
    BOOST_TEST(judge.last().error == 1.0 / 16);
}

BOOST_AUTO_TEST_CASE(an_estimate_of_lower_order_counts_by_its_ratio) {
    bare_judge judge({}, 0.0, {});
    judge.prepare(0, 0.01);
    attempt step = step_of(50);
    BOOST_TEST(judge(step).accepted);
    attempt worse = step_of(200);
    BOOST_TEST(!judge(worse).accepted);
}

BOOST_AUTO_TEST_CASE(an_error_above_one_shortens_the_step_by_its_root_and_a_first_step_by_ten) {
    bare_judge judge({}, 0.0, {});
    judge.prepare(0, 1.0);
    attempt step = step_of(16);
    auto said = judge(step);
    BOOST_TEST(!said.accepted);
    BOOST_TEST(said.next_h == 0.1 * 0.9 / 2, near);
    step = step_of(16);
    step.first = true;
    step.again = 16;
    said = judge(step);
    BOOST_TEST(said.next_h == 0.01, near);
    step = step_of(NAN);
    said = judge(step);
    BOOST_TEST((!said.accepted && std::isnan(said.error)));
    BOOST_TEST(said.next_h == 0.1 / 8, near);
}

BOOST_AUTO_TEST_CASE(an_error_that_does_not_follow_the_step_shortens_it_by_eight) {
    bare_judge judge({}, 0.0, {});
    judge.prepare(0, 1.0);
    attempt step = step_of(4);
    step.again = 4;
    step.refused = {1, 1, 0, 0.2, 4.2};
    BOOST_TEST(judge(step).next_h == 0.1 / 8, near);
    step = step_of(4);
    step.again = 4;
    step.refused = {1, 1, 0, 0.2, 16};
    BOOST_TEST(judge(step).next_h == 0.1 * 0.9 / std::sqrt(2), near);
}

BOOST_AUTO_TEST_CASE(a_refused_estimate_is_filtered_once_more_and_a_fresh_one_is_not) {
    bare_judge judge({}, 0.0, {});
    judge.prepare(0, 1.0);
    attempt step = step_of(5);
    step.again = 0.5;
    BOOST_TEST(!judge(step).accepted);
    BOOST_TEST(step.asked == 0);
    step = step_of(5);
    step.again = 0.5;
    step.refused.all = 1;
    const auto said = judge(step);
    BOOST_TEST(said.accepted);
    BOOST_TEST(said.next_h <= 0.1);  // a step that was refused does not grow at once
    step = step_of(0.5);
    step.right = 3;
    BOOST_TEST(!judge(step).accepted);  // the right end shows more
}

BOOST_AUTO_TEST_CASE(more_iterations_make_the_next_step_more_careful) {
    bare_judge judge({}, 0.0, {});
    judge.prepare(0, 1.0);
    attempt step = step_of(1.0 / 16);
    step.iterations = 7;
    step.usual_iterations = 7;
    BOOST_TEST(judge(step).next_h == 0.1 * 2 * 0.9 * 15 / 21, near);
}

BOOST_AUTO_TEST_CASE(a_step_that_could_grow_little_stays_for_its_factors) {
    bare_judge judge({}, 0.0, {});
    judge.prepare(0, 1.0);
    attempt step = step_of(0.4);  // 0.9 * 0.4^{-1/4} = 1.13
    step.hold = 1.2;
    BOOST_TEST(judge(step).next_h == 0.1);
    bare_judge another({}, 0.0, {});
    another.prepare(0, 1.0);
    step = step_of(0.4);
    BOOST_TEST(another(step).next_h == 0.1 * 0.9 * std::pow(0.4, -0.25), near);
}

namespace {
struct raising : sc::guard_defaults {
    double to;
    explicit raising(double x) : to(x) {}
    template <class Step>
    double look(Step&, double error) const {
        return sc::larger(error, to);
    }
    template <class Step>
    double bound(Step&, double next_h) const {
        return std::min(next_h, 0.15);
    }
};
}  // namespace

BOOST_AUTO_TEST_CASE(guards_raise_the_error_and_bound_the_step) {
    sc::judge<double, 1, std::tuple<raising>> judge({}, 0.0, std::tuple(raising(0.1)));
    judge.prepare(0, 1.0);
    attempt step = step_of(0.01);
    const auto said = judge(step);
    BOOST_TEST(said.error == 0.1);
    BOOST_TEST(said.next_h == 0.15);
    sc::judge<double, 1, std::tuple<raising>> refusing({}, 0.0, std::tuple(raising(2)));
    refusing.prepare(0, 1.0);
    step = step_of(0.01);
    BOOST_TEST(!refusing(step).accepted);
}

BOOST_AUTO_TEST_CASE(the_predictive_controller_follows_a_trend_and_never_beats_the_elementary_one) {
    sc::step_size_controller<double> control(sc::step_control::predictive);
    BOOST_TEST(control.after_accepted(0.1, 1.0 / 16, 4, 0.9) == 1.8, near);
    // err = C h^4, C grown by 16 from the last step: expected to grow so again
    BOOST_TEST(control.expected(0.1, 4) == 1.0 / 16, near);
    BOOST_TEST(control.after_accepted(0.1, 1.0, 4, 0.9) == 0.45, near);
    BOOST_TEST(control.after_accepted(0.1, 1.0 / 16, 4, 0.9) == 1.8, near);  // improved: elementary
    control.forget();
    BOOST_TEST(control.expected(0.1, 4) == 0.0);
    BOOST_TEST(control.after_accepted(0.1, 1e-30, 4, 0.9) == 8.0);  // eight at most
    BOOST_TEST(control.after_rejected(1e30, 4, 0.9) == 0.125);
    BOOST_TEST(control.after_rejected(81, 4, 0.9) == 0.3, near);
}

BOOST_AUTO_TEST_CASE(the_proportional_integral_controller_is_that_of_the_book) {
    sc::step_size_controller<double> control(sc::step_control::proportional_integral);
    control.after_accepted(0.1, 0.5, 5, 0.9);
    BOOST_TEST(
        control.after_accepted(0.1, 0.25, 5, 0.9) == 0.9 * std::pow(0.25, -0.7 / 5) * std::pow(0.5, 0.4 / 5),
        near);
}

BOOST_AUTO_TEST_CASE(a_plan_ends_at_t1_and_leaves_no_tiny_last_step) {
    sc::step_plan<double> plan(0.0, 1.0, {});
    auto next = plan.next(0.0, 0.3, 0, 0);
    BOOST_TEST(next.h == 0.3);
    BOOST_TEST(next.t_next == 0.3);
    next = plan.next(0.5, 0.4, 1, 0);  // two steps of a quarter, not one and a tiny one
    BOOST_TEST(next.h == 0.25);
    next = plan.next(0.5, 0.6, 1, 0);
    BOOST_TEST(next.t_next == 1.0);
    BOOST_TEST((plan.next(0.5, 0.1, 1, 61).obstacle == sc::status::step_underflow));
    sc::step_plan<double> short_run(0.0, 1.0, {.max_steps = 1});
    short_run.next(0.0, 0.1, 0, 0);
    BOOST_TEST((short_run.next(0.0, 0.1, 0, 0).obstacle == sc::status::too_many_steps));
    sc::step_plan<double> backwards(1.0, 0.0, {.max_step = 0.2});
    BOOST_TEST(backwards.first(5.0, 1.0) == -0.2);
    BOOST_TEST(backwards.bounded(-7.0) == -0.2);
}

BOOST_AUTO_TEST_CASE(newtons_iteration_ends_when_what_is_left_is_small_and_when_it_cannot_be) {
    const auto run = [](sc::newton_limits<double> limits, std::vector<double> sizes) {
        sc::newton_monitor<double> monitor(limits);
        for (double size : sizes)
            if (!monitor.may_go_on() || monitor.over(size)) break;
        return monitor.outcome();
    };
    const sc::newton_limits<double> usual{0.02, 1e-15, 1e-13, 7};
    auto end = run(usual, {1, 1e-2, 1e-4});
    BOOST_TEST((end.end == sc::newton_end::converged));
    BOOST_TEST(end.iterations == 2);  // 1e-2 * 1e-2 / (1 - 1e-2) is left
    BOOST_TEST(end.theta == 1e-2, near);
    end = run(usual, {1, 0.9, 0.8, 0.7});
    BOOST_TEST((end.end == sc::newton_end::diverged));  // seven iterations do not reach it
    BOOST_TEST(end.iterations == 2);
    end = run(usual, {1, NAN});
    BOOST_TEST((end.end == sc::newton_end::non_finite));
    end = run(usual, {1e-16});
    BOOST_TEST((end.end == sc::newton_end::converged));
    end = run({0.02, 1e-15, 1e-13, 7, true}, {1e3});  // f is affine: one is enough
    BOOST_TEST((end.end == sc::newton_end::converged));
    sc::newton_limits<double> guessed = usual;
    guessed.far = 100;
    BOOST_TEST((run(guessed, {101}).end == sc::newton_end::diverged));
    BOOST_TEST((run(usual, {5e-14, 4e-14}).end == sc::newton_end::converged));  // rounding
}

BOOST_AUTO_TEST_CASE(unsolved_stages_end_a_run_with_what_they_ran_into) {
    const auto why = [](const sc::unsolved_attempt& a) { return sc::why_unsolved(a); };
    BOOST_TEST((why({}) == sc::status::newton_failed));
    BOOST_TEST((why({.singular = true}) == sc::status::singular_matrix));
    BOOST_TEST((why({.singular = true, .finite_data = false}) == sc::status::non_finite));
    BOOST_TEST((why({.finite_stages = false}) == sc::status::non_finite));
    BOOST_TEST((why({.finite_stages = false, .unsolved_linear = true}) == sc::status::linear_solver_failed));
}

BOOST_AUTO_TEST_CASE(of_what_may_help_the_cheapest_is_tried_first) {
    const auto remedy = [](const sc::unsolved_attempt& a) { return sc::remedy_for(a); };
    BOOST_TEST((remedy({}) == sc::remedy::shorter_step));
    BOOST_TEST((remedy({.noisy_guess = true}) == sc::remedy::constant_guess));
    BOOST_TEST((remedy({.old_jacobian = true, .noisy_guess = true}) == sc::remedy::new_jacobian));
    BOOST_TEST((remedy({.fixed = true, .old_jacobian = true}) == sc::remedy::new_jacobian));
    BOOST_TEST((remedy({.finite_stages = false, .fixed = true, .old_jacobian = true, .new_border = true}) ==
                sc::remedy::continued_f));
    BOOST_TEST((remedy({.finite_stages = false, .unsolved_linear = true, .new_border = true}) ==
                sc::remedy::shorter_step));
    BOOST_TEST((remedy({.fixed = true, .noisy_guess = true}) == sc::remedy::none));
}

BOOST_AUTO_TEST_CASE(a_contraction_that_no_shorter_step_makes_faster_is_that_of_a_kink) {
    BOOST_TEST(sc::meets_a_kink(3.0, 3.0, 3, 3));
    BOOST_TEST(sc::meets_a_kink(0.9, 1.0, 3, 3));
    BOOST_TEST(!sc::meets_a_kink(1.0, 2.0, 3, 3));   // O(h)
    BOOST_TEST(!sc::meets_a_kink(0.4, 0.4, 3, 3));   // it is small enough
    BOOST_TEST(!sc::meets_a_kink(3.0, 0.0, 3, 3));   // there is none to compare with
    BOOST_TEST(!sc::meets_a_kink(3.0, 3.0, 2, 15));  // shorter steps may help yet
    BOOST_TEST(sc::meets_a_kink(3.0, 3.0, 1, 16));   // they end just before it, one after the other
}

BOOST_AUTO_TEST_CASE(what_iterations_came_to_is_kept_while_step_after_step_has_one_that_failed) {
    sc::attempts<double> tries;
    sc::report<double> counts;
    BOOST_TEST(tries.theta_of_longer(1) == 0);
    tries.unsolved(sc::status::newton_failed, counts);
    tries.shortened(-0.5, 2);
    BOOST_TEST(tries.theta_of_longer(0.25) == 2);
    BOOST_TEST(tries.theta_of_longer(0.5) == 0);  // that one was no longer
    tries.begin();
    BOOST_TEST(tries.refused().all == 0);
    BOOST_TEST(tries.in_a_row() == 1);
    BOOST_TEST(tries.theta_of_longer(0.25) == 2);
    tries.unsolved(sc::status::newton_failed, counts);
    tries.begin();
    BOOST_TEST(tries.in_a_row() == 2);
    tries.begin();  // behind a step without such a failure
    BOOST_TEST(tries.in_a_row() == 0);
    BOOST_TEST(tries.theta_of_longer(0.25) == 0);
}

BOOST_AUTO_TEST_CASE(an_error_that_does_not_fall_with_the_step_may_be_of_its_start) {
    sc::attempts<double> tries;
    sc::report<double> counts;
    BOOST_TEST(tries.may_be_of_the_start(true));  // in the first step
    BOOST_TEST(!tries.may_be_of_the_start(true));
    tries.too_large(0.5, 100, counts);
    tries.begin();
    tries.too_large(0.5, 100, counts);
    BOOST_TEST(!tries.may_be_of_the_start(false));
    tries.too_large(0.1, 89, counts);
    BOOST_TEST(!tries.may_be_of_the_start(false));
    tries.too_large(0.01, 88, counts);
    BOOST_TEST(tries.may_be_of_the_start(false));
    BOOST_TEST(!tries.may_be_of_the_start(false));  // once in a step
}

BOOST_AUTO_TEST_CASE(attempts_count_what_was_refused_and_keep_what_ends_the_run) {
    sc::attempts<double> tries;
    sc::report<double> counts;
    BOOST_TEST((tries.obstacle() == sc::status::step_underflow));
    tries.unsolved(sc::status::newton_failed, counts);
    BOOST_TEST((tries.obstacle() == sc::status::newton_failed));
    tries.too_large(0.5, 3, counts);
    tries.not_finite(sc::status::non_finite, counts);
    BOOST_TEST((tries.obstacle() == sc::status::non_finite));
    tries.forbidden(counts);
    const auto& all = tries.refused();
    BOOST_TEST((all.all == 4 && all.for_error == 1 && all.by_newton == 1 && all.h == 0.5 && all.error == 3));
    BOOST_TEST((counts.rejected_error == 2 && counts.rejected_newton == 2));
    tries.begin();
    BOOST_TEST(tries.refused().all == 0);
}

BOOST_AUTO_TEST_CASE(after_a_failure_newtons_iteration_gets_more_room) {
    const sc::options<double> o{.rtol = 1e-6};
    BOOST_TEST(sc::newton_room(o, 3, 1, true, 0, false).iterations == 7);
    BOOST_TEST(sc::newton_room(o, 3, 1, true, 1, false).iterations == 14);
    BOOST_TEST(sc::newton_room(o, 3, 1, true, 5, false).iterations == 21);
    BOOST_TEST(sc::newton_room(o, 7, 1, true, 0, false).iterations == 17);
    BOOST_TEST(sc::newton_room(o, 3, 2, false, 0, false).patience == 3);
    BOOST_TEST(sc::newton_room(o, 5, 2, false, 0, false).factor == 0.02 * 27 / 125, near);
    BOOST_TEST(sc::newton_room(o, 3, 2, false, 0, false).factor == 0.02, near);
}

BOOST_AUTO_TEST_CASE(a_polynomial_that_led_astray_is_not_extrapolated_for_a_while) {
    sc::extrapolation_trust trust;
    BOOST_TEST(trust.trusted());
    trust.failed();
    BOOST_TEST(!trust.trusted());
    trust.stepped();
    BOOST_TEST(trust.trusted());
    trust.failed();  // twice as long
    for (int k = 0; k < 3; ++k) {
        BOOST_TEST(!trust.trusted());
        trust.stepped();
    }
    BOOST_TEST(trust.trusted());
}
