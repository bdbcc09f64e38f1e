// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE guards
#include <boost/test/unit_test.hpp>

#include <cmath>

#include <stagecraft/judge/guards/first_step.hpp>
#include <stagecraft/judge/guards/index.hpp>
#include <stagecraft/judge/guards/jumps.hpp>
#include <stagecraft/judge/guards/phase.hpp>
#include <stagecraft/judge/guards/rounding.hpp>

#include "attempt.hpp"

// Each guard on plain numbers: what it raises, what it lets pass, and that it asks for nothing outside of its class.

namespace sc = stagecraft;

namespace {

const auto near = boost::test_tools::tolerance(1e-14);

attempt step_of(double h, int power = 4) {
    attempt step;
    step.h = h;
    step.t_next = step.t + h;
    step.power = power;
    step.last = {h, 0.5, 0};
    return step;
}

template <class Guard>
Guard started(sc::options<double> o = {}, double t0 = 0) {
    Guard guard;
    guard.start(o, t0);
    return guard;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_large_unexpected_error_begins_the_doubt_in_smoothness) {
    sc::smoothness<double> smooth;
    BOOST_TEST(!smooth.surprised(10, 1e-3, false));  // not notable
    BOOST_TEST(!smooth.surprised(999, 1, false));    // less than a thousand times what was expected
    BOOST_TEST(!smooth.surprised(1e6, 0, false));    // nothing was expected
    BOOST_TEST(smooth.surprised(1001, 1, false));
    for (int accepted = 0; accepted < 9; ++accepted) BOOST_TEST(!smooth.accepted());
    BOOST_TEST(smooth.doubted());
    BOOST_TEST(smooth.accepted());  // the tenth in a row ends it
    BOOST_TEST(!smooth.doubted());
    BOOST_TEST(smooth.surprised(1.5, 0, true));  // refused before, and still too large
    for (int accepted = 0; accepted < 5; ++accepted) smooth.accepted();
    BOOST_TEST(!smooth.surprised(2, 0, false));  // begins no doubt, but the ten steps are counted anew
    for (int accepted = 0; accepted < 9; ++accepted) BOOST_TEST(!smooth.accepted());
    BOOST_TEST(smooth.accepted());
}

BOOST_AUTO_TEST_CASE(steps_after_a_jump_are_half_as_long_as_the_last_two_are_apart) {
    sc::jump_spacing<double> spacing(2.0);
    BOOST_TEST(spacing.largest(5.0) == 0.0);  // none known, no bound
    BOOST_TEST(spacing.since(5.0) == 3.0);
    spacing.found(6.0, 0.5);  // the start counts as one: 4 apart
    BOOST_TEST(spacing.largest(6.5) == 2.0);
    BOOST_TEST(spacing.largest(16.0) == 5.0);  // half of the way from the last one
    spacing.found(6.25, 0.25);                 // the same jump, found more closely
    BOOST_TEST(spacing.largest(6.5) == 2.125);
    spacing.found(8.0, 0.125);  // the next: 1.75 behind 6.25, which may lie 0.25 further
    BOOST_TEST(spacing.largest(8.0) == 0.75);
}

BOOST_AUTO_TEST_CASE(a_suspicion_at_a_blind_spot_is_tried_again_with_half_of_the_step) {
    using watch_type = sc::jump_watch<double>;
    using verdict = watch_type::verdict;
    watch_type watch;
    BOOST_TEST((watch.judge(0.1, 1, 4) == verdict::smooth));
    watch.accepted();
    BOOST_TEST((watch.judge(0.1, 9.9, 4) == verdict::smooth));  // below ten tolerances
    watch.accepted();
    BOOST_TEST((watch.judge(0.2, 9.9 * 16 * 10, 4) == verdict::smooth));  // ten times what h^4 predicts
    BOOST_TEST((watch.judge(0.1, 1e4, 4) == verdict::suspicion));
    BOOST_TEST((watch.judge(0.05, 1e4 / 30, 4) == verdict::smooth));  // falls by more than h^{5/2}: smooth
    watch.accepted();
    watch.judge(0.05, 1, 4);
    watch.accepted();
    BOOST_TEST((watch.judge(0.1, 1e5, 4) == verdict::suspicion));
    BOOST_TEST((watch.judge(0.05, 5e4, 4) == verdict::jump));  // falls as h
}

BOOST_AUTO_TEST_CASE(across_a_jump_the_estimate_stands_for_itself_until_ten_steps_have_met_it) {
    auto guard = started<sc::jump_guard<double>>();
    attempt step = step_of(0.1);
    step.smooth = step.ratio = 0.01;
    step.across = 1;
    step.left = step.measured = 2e3;
    step.expected = 0.01;
    guard.begin(step);
    BOOST_TEST(step.ratio == 0.01);
    BOOST_TEST(guard.look(step, 20.0) == 20.0);
    BOOST_TEST(
        !step.continues);  // more than a thousand times what was expected: from here on it counts in full
    BOOST_TEST(step.ratio == 1.0);
    attempt next = step_of(0.01);
    next.smooth = next.ratio = 0.01;
    guard.begin(next);
    BOOST_TEST(next.ratio == 1.0);
    for (int k = 0; k < 9; ++k) {
        sc::outlook<double> seen{0.5};
        guard.accepted(next, seen);
        BOOST_TEST((seen.continues && !seen.smooth && seen.error == 0.5));
    }
    sc::outlook<double> seen{0.5};
    guard.accepted(next, seen);  // the tenth: the ratio of smooth solutions holds again
    BOOST_TEST((!seen.continues && seen.smooth));
    BOOST_TEST(seen.error == 0.005, near);
}

BOOST_AUTO_TEST_CASE(a_jump_is_known_by_an_error_that_does_not_fall_with_the_step) {
    sc::refusals<double> refused;
    refused.h = 0.2;
    refused.error = 1000;
    BOOST_TEST(!refused.stays(0.1, 1000 / 16.0, 4));                // h^4
    BOOST_TEST(!refused.stays(0.1, 1000 * std::pow(0.5, 2.5), 4));  // on the border
    BOOST_TEST(refused.stays(0.1, 1001 * std::pow(0.5, 2.5), 4));
    BOOST_TEST(refused.falls(899));
    BOOST_TEST(!refused.falls(901));
    auto guard = started<sc::jump_guard<double>>();
    attempt step = step_of(0.1);
    step.t = 3;
    step.refused = refused;
    step.refused.for_error = 1;
    guard.refused(step, 500.0);
    attempt later = step_of(1);
    later.t_next = 4;
    BOOST_TEST(guard.bound(later, 10.0) == 1.5);  // half as long as the jump is behind the start
    BOOST_TEST(guard.bound(later, -10.0) == -1.5);
    BOOST_TEST(guard.bound(later, 1.0) == 1.0);
}

BOOST_AUTO_TEST_CASE(before_the_first_jump_only_a_constant_slope_bounds_the_steps) {
    auto guard = started<sc::jump_guard<double>>({}, 1.0);
    attempt step = step_of(0.5);
    step.t_next = 3;
    BOOST_TEST(guard.bound(step, 9.0) == 9.0);
    step.constant_slope = true;
    BOOST_TEST(guard.bound(step, 9.0) == 2.0);  // all that the run has seen
    BOOST_TEST(guard.bound(step, 1.5) == 1.5);
    auto off = started<sc::jump_guard<double>>({.jumps = false}, 1.0);
    BOOST_TEST(off.bound(step, 9.0) == 9.0);
}

BOOST_AUTO_TEST_CASE(a_jump_that_t_does_not_resolve_is_passed_and_a_singularity_is_not) {
    auto guard = started<sc::jump_guard<double>>();
    attempt step = step_of(1e-16);
    step.last = {1e-16, 0.5, 0};
    BOOST_TEST(guard.passes(step, 51.0));
    BOOST_TEST(!guard.passes(step, 49.0));  // a hundred times the last: errors that grow gradually
    BOOST_TEST(!guard.passes(step, 1000.0));
    step.last.h = 0;
    BOOST_TEST(!guard.passes(step, 51.0));
}

BOOST_AUTO_TEST_CASE(a_decaying_stiff_component_behind_a_jump_counts_a_tenth) {
    auto guard = started<sc::jump_guard<double>>();
    attempt step = step_of(0.1);
    step.once = 400;
    BOOST_TEST(guard.estimated(step, 0.3) == 0.3);  // no doubt, not refused
    step.refused.for_error = 1;
    step.refused.h = 0.2;
    step.refused.error = 500;
    BOOST_TEST(guard.estimated(step, 0.3) == 40.0);
    step.identity = false;
    BOOST_TEST(guard.estimated(step, 0.3) == 0.3);
}

BOOST_AUTO_TEST_CASE(a_blind_spot_that_shows_a_jump_replaces_the_error) {
    auto guard = started<sc::jump_guard<double>>();
    attempt step = step_of(0.1);
    step.spots = 1;
    step.sign = 1;
    const auto look = [&](double error) {
        guard.begin(step);
        return guard.look(step, error);
    };
    const auto accept = [&] {
        sc::outlook<double> seen{0.5};
        guard.accepted(step, seen);
    };
    BOOST_TEST(look(0.5) == 0.5);
    accept();
    step.sign = 1e4;
    BOOST_TEST(look(0.5) == std::pow(1.8, 4), near);  // asks for half of the step: 0.9 / 1.8
    step.h = 0.05;
    step.sign = 5e3;
    BOOST_TEST(look(0.5) == 5e3);
    const int before = step.asked;
    BOOST_TEST(look(3.0) == 3.0);  // refused anyway: nothing is measured
    BOOST_TEST(step.asked == before);
}

BOOST_AUTO_TEST_CASE(where_the_estimate_passes_zero_a_quarter_of_the_output_error_is_expected) {
    auto guard = started<sc::phase_guard<double>>();
    attempt step = step_of(0.1);
    step.stages = 3;
    step.output = 5;
    const auto accept = [&] {
        sc::outlook<double> seen{0.5};
        guard.accepted(step, seen);
    };
    BOOST_TEST(guard.look(step, 0.5) == 0.5);  // no step before to go by
    accept();
    step.last = {0.1, 0.5, 0};
    BOOST_TEST(guard.look(step, 1e-6) == 0.5 / 5 / 4 * 5, near);
    step.output = 40;
    BOOST_TEST(guard.look(step, 1e-6) == 1.0, near);
    BOOST_TEST(guard.look(step, 2.0) == 2.0);
    step.h = 0.05;  // half of the step: a quarter of it, with three stages
    BOOST_TEST(guard.look(step, 1e-6) == 0.25, near);
    step.output = 0.9;  // within the tolerance between the ends: nothing to fear
    BOOST_TEST(guard.look(step, 1e-6) == 1e-6);
    step.output = 40;
    step.refused.all = 1;
    BOOST_TEST(guard.look(step, 1e-6) == 1e-6);
    step.refused.all = 0;
    step.stages = 2;
    const int before = step.asked;
    BOOST_TEST(guard.look(step, 1e-6) == 1e-6);
    BOOST_TEST(step.asked == before);
}

BOOST_AUTO_TEST_CASE(with_continuous_the_error_between_the_ends_counts_in_full) {
    attempt step = step_of(0.1);
    step.stages = 3;
    step.output = 5;
    auto with = started<sc::output_guard<double>>({.continuous = true});
    BOOST_TEST(with.look(step, 0.5) == 5.0);
    BOOST_TEST(with.look(step, 7.0) == 7.0);
    auto without = started<sc::output_guard<double>>();
    BOOST_TEST(without.look(step, 0.5) == 0.5);
    auto phase = started<sc::phase_guard<double>>({.continuous = true});
    const int before = step.asked;
    BOOST_TEST(phase.look(step, 0.5) == 0.5);
    BOOST_TEST(step.asked == before);
}

BOOST_AUTO_TEST_CASE(between_the_ends_an_observer_brings_the_algebraic_components_and_a_kink_counts) {
    attempt step = step_of(0.1);
    step.stages = 3;
    step.output = 0.9, step.watched_output = 0.7;
    step.between = 9.5, step.watched_between = 7.5;
    auto nobody = started<sc::output_guard<double>>();
    BOOST_TEST(nobody.look(step, 0.5) == 0.5);
    BOOST_TEST(step.asked == 0);
    step.watched = true;
    BOOST_TEST(nobody.look(step, 0.5) ==
               7.5);  // of the algebraic components alone, more than ten times as much
    auto all = started<sc::output_guard<double>>({.continuous = true});
    BOOST_TEST(all.look(step, 0.5) == 9.5);
    step.between = 8.5;  // it does not contradict the coefficients
    BOOST_TEST(all.look(step, 0.5) == 0.9);
    step.watched_output = 3;  // refused already: nothing more is measured
    const int before = step.asked;
    BOOST_TEST(nobody.look(step, 0.5) == 3.0);
    BOOST_TEST(step.asked == before + 1);
}

BOOST_AUTO_TEST_CASE(a_first_step_is_judged_between_its_nodes_and_no_other_is) {
    sc::first_step_guard<double> guard;
    attempt step = step_of(0.1);
    step.between = 300;
    step.ratio = 0.1;
    BOOST_TEST(guard.look(step, 0.5) == 0.5);
    step.first = true;
    BOOST_TEST(guard.look(step, 2.0) == 2.0);
    BOOST_TEST(step.asked == 0);
    BOOST_TEST(guard.look(step, 0.5) == 30.0, near);
    step.ratio = 5;  // an estimate that is a part of the error says nothing of this one
    BOOST_TEST(guard.look(step, 0.5) == 300.0);
}

BOOST_AUTO_TEST_CASE(of_an_index_2_error_a_step_counts_the_share_that_it_hands_on) {
    sc::index_guard<double> guard;
    attempt step = step_of(0.1);  // power 4: s = 3
    guard.begin(step);
    BOOST_TEST(step.share == 1.0);  // index 1
    step.index = 2;
    guard.begin(step);
    BOOST_TEST(step.share == 1.0);  // not stiffly accurate
    step.from_start = true;
    guard.begin(step);
    BOOST_TEST(step.share == 0.75, near);  // equal steps: s / (s + 1)
    step.h = 0.2;
    guard.begin(step);
    BOOST_TEST(step.share == 24.0 / 11, near);  // s g / (s + g), g = 8
    step.last.h = 0;
    guard.begin(step);
    BOOST_TEST(step.share == 3.0, near);  // z_0 is consistent: all of it
    step.last = {0.2, 0.5, 1};
    guard.begin(step);  // the method before had more stages
    BOOST_TEST(step.share == 3.0, near);
    step.method = 2;
    guard.begin(step);  // it had fewer: 1 / (s - 1)
    BOOST_TEST(step.share == 0.5, near);
}

BOOST_AUTO_TEST_CASE(what_an_estimate_shows_beyond_forty_tolerances_is_not_from_the_step_before) {
    sc::index_guard<double> guard;
    attempt step = step_of(0.1);
    step.index = 2;
    step.share = 0.01;
    step.raised = 90;
    step.measured = 0.5;
    BOOST_TEST(guard.estimated(step, 0.9) == 50.0, near);
    step.raised = 40;
    BOOST_TEST(guard.estimated(step, 0.9) == 0.9);
    step.share = 1;
    step.raised = 90;
    BOOST_TEST(guard.estimated(step, 90.0) == 90.0);
}

BOOST_AUTO_TEST_CASE(an_index_2_error_that_four_refusals_leave_as_it_is_is_inherited) {
    sc::index_guard<double> guard;
    attempt step = step_of(0.1);
    step.index = 2;
    step.share = 0.1;
    step.raised = 100;
    step.measured = 0.5;
    step.once = 10;
    step.refused.for_error = 4;
    step.refused.error = 10.5;
    BOOST_TEST(guard.estimated(step, 10.0) == 0.5, near);  // without z
    sc::outlook<double> seen{0.5};
    guard.accepted(step, seen);
    BOOST_TEST(!seen.continues);
    step.share = 0.1;
    step.refused.error = 20;  // it does fall
    BOOST_TEST(guard.estimated(step, 10.0) == 10.0);
    step.refused.error = 10.5;
    BOOST_TEST(guard.estimated(step, 41.0) == 41.0);  // too much to be inherited
}

BOOST_AUTO_TEST_CASE(an_error_that_is_rounding_lets_a_short_step_pass_and_the_next_one_be_longer) {
    sc::rounding_guard<double> guard;
    attempt step = step_of(1e-6);
    step.rounding = 20;
    BOOST_TEST(guard.look(step, 0.9) == 0.9);
    step.h = 1e-5;
    BOOST_TEST(guard.look(step, 150.0) == 150.0);  // longer than the step before: not yet looked at
    BOOST_TEST(step.asked == 0);
    step.h = 1e-6;
    BOOST_TEST(guard.look(step, 201.0) == 201.0);  // more than ten roundings: an error
    BOOST_TEST(guard.bound(step, 1e-6) == 1e-6);
    BOOST_TEST(guard.look(step, 199.0) == 0.5);
    sc::outlook<double> seen{0.5};
    guard.accepted(step, seen);
    BOOST_TEST(!seen.continues);
    BOOST_TEST(step.at_rounding == 1);
    BOOST_TEST(guard.bound(step, 1e-6) == 2e-4, near);
    step.longest_step =
        1e-4;  // no step of the run has been as long as rounding needs: the tolerance is too small
    BOOST_TEST(guard.look(step, 199.0) == 199.0);
    step.rounding = 0.5;  // within the tolerance
    BOOST_TEST(guard.look(step, 3.0) == 0.5);
}

BOOST_AUTO_TEST_CASE(no_run_ends_with_a_step_that_is_all_rounding) {
    sc::rounding_guard<double> guard;
    attempt step = step_of(1e-6);
    step.ends = true;
    step.rounding = 0.5;
    BOOST_TEST(guard.look(step, 3.0) == 0.5);
    step.rounding = 20;
    BOOST_TEST(guard.look(step, 150.0) == 150.0);
    step.ends = false;  // nor does it creep there in shorter and shorter ones
    BOOST_TEST(guard.look(step, 150.0) == 150.0);
    // Behind one that has passed, a small estimate of the last step may be rounding too: where y stands still, it is zero.
    sc::rounding_guard<double> other;
    step.ends = true;
    BOOST_TEST(other.look(step, 0.1) == 0.1);
    step.ends = false;
    sc::outlook<double> seen{0.5};
    BOOST_TEST(other.look(step, 150.0) == 0.5);
    other.accepted(step, seen);
    BOOST_TEST(other.look(step, 0.1) == 0.1);
    step.ends = true;
    BOOST_TEST(other.look(step, 0.1) == 20.0);
    step.rounding = 9;
    BOOST_TEST(other.look(step, 0.1) == 0.1);
}
