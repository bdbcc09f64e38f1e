// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE events
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stagecraft/checkpoint.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/global_error.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/progress.hpp>
#include <stagecraft/observe/save_every.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/observe/table.hpp>
#include <stagecraft/steps.hpp>
#include <string>

#include "../message.hpp"

namespace sc = stagecraft;
using sc::crossing;
using V1 = Eigen::Matrix<double, 1, 1>;
using Eigen::Vector2d;
using Eigen::Vector4d;
using std::numbers::pi;
const auto within = [](double relative) { return boost::test_tools::tolerance(relative); };

namespace {

const auto radau = sc::radau_iia<3>();

// y = t, so that an event function says where its zeros are; the solution is exact.
const auto clock_rate = [](double, const V1&, V1& f) { f[0] = 1; };

const auto free_fall = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -1; };

const auto pendulum = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -std::sin(y[0]); };

// (q, p), eccentricity 0.6, at the pericentre at t = 0, period 2 pi.
const auto kepler = [](double, const Vector4d& y, Vector4d& f) {
    const double r = std::hypot(y[0], y[1]);
    f << y[2], y[3], -y[0] / (r * r * r), -y[1] / (r * r * r);
};
const Vector4d pericentre(0.4, 0, 0, 2);

const auto component = [](int i) { return [i](double, const auto& y) { return y[i]; }; };
const auto time_minus = [](double root) { return [root](double, const V1& y) { return y[0] - root; }; };

template <class Watch>
auto run_clock(double t0, double t1, double step, Watch& watch) {
    return sc::integrate(radau, clock_rate, V1(t0), t0, t1, {.fixed_step = step}, watch);
}

std::string message_of(const std::exception_ptr& thrown) {
    return message<std::exception>([&] { std::rethrow_exception(thrown); });
}

}  // namespace

// Dropped from rest at height 1/2, g = 1: the first impact at 1, then flights of 2 e^k.
BOOST_AUTO_TEST_CASE(a_bouncing_ball_hits_the_ground_when_it_should) {
    const double restitution = 0.5;
    for (const crossing direction : {crossing::falling, crossing::both}) {
        auto ground = sc::events<Vector2d>(
            sc::event(component(0), {.direction = direction, .terminal = true}), sc::event(component(1)));
        Vector2d y(0.5, 0);
        double t = 0, expected = 1, speed = 1;
        for (int bounce = 0; bounce < 12; ++bounce) {
            const auto r = sc::integrate(radau, free_fall, y, t, 10, {.rtol = 1e-10, .atol = 1e-12}, ground);
            BOOST_TEST(sc::name(r.status) == "event");
            BOOST_TEST(!r.ok());
            BOOST_TEST(std::abs(r.t - expected) < 2e-14);
            BOOST_TEST(std::abs(r.y[0]) < 1e-14);
            BOOST_TEST(r.y[1] == -speed, within(1e-11));
            BOOST_TEST(ground.ended());
            // The apex of each flight, but not that of the drop, which is where the run starts.
            BOOST_REQUIRE(ground.found().size() == (bounce == 0 ? 1u : 2u));
            if (bounce > 0) {
                BOOST_TEST(ground.found()[0].event == 1);
                BOOST_TEST(std::abs(ground.found()[0].t - (expected - speed)) < 2e-14);
                BOOST_TEST((ground.found()[0].direction == crossing::falling));
            }
            BOOST_TEST(ground.found().back().event == 0);
            BOOST_TEST((ground.found().back().y == r.y));
            t = r.t;
            speed *= restitution;
            y << r.y[0], speed;
            expected += 2 * speed;
        }
    }
}

// The flights end after 1 + 2 (e + e^2 + ...) = 3, of which all bounces slower than 1e-9 take 4e-9.
BOOST_AUTO_TEST_CASE(a_ball_lies_still_once_its_speed_no_longer_matters) {
    auto ground =
        sc::events<Vector2d>(sc::event(component(0), {.direction = crossing::falling, .terminal = true}));
    Vector2d y(0.5, 0);
    double t = 0;
    int bounces = 0;
    while (bounces == 0 || y[1] > 1e-9) {
        const auto r = sc::integrate(radau, free_fall, y, t, 10, {.rtol = 1e-10, .atol = 1e-12}, ground);
        BOOST_REQUIRE((r.status == sc::status::event));
        t = r.t;
        y << 0, -r.y[1] / 2;
        ++bounces;
    }
    BOOST_TEST(bounces == 30);
    BOOST_TEST(std::abs(t - 3) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_ball_that_moves_up_meets_no_falling_event) {
    auto ground = sc::events<Vector2d>(sc::event(component(0), {.direction = crossing::falling}));
    const auto r = sc::integrate(radau, free_fall, Vector2d(0, 5), 0, 4, {}, ground);
    BOOST_TEST(r.ok());
    BOOST_TEST(r.t == 4);
    BOOST_TEST(ground.found().empty());
    BOOST_TEST(!ground.ended());
}

// Amplitude 1: the period is 4 K(sin(1/2)).
BOOST_AUTO_TEST_CASE(a_pendulum_passes_its_lowest_point_every_half_period) {
    const double period = 4 * std::comp_ellint_1(std::sin(0.5));
    for (const int sense : {1, -1}) {  // time forth and back: the pendulum is reversible
        auto low = sc::events<Vector2d>(sc::event(component(0)),
                                        sc::event(component(0), {.direction = crossing::rising}),
                                        sc::event(component(0), {.direction = crossing::falling}));
        const auto r = sc::integrate(sc::radau_iia<5>(), pendulum, Vector2d(1, 0), 0, sense * 20,
                                     {.rtol = 1e-12, .atol = 1e-12}, low);
        BOOST_TEST(r.ok());
        const int crossings = static_cast<int>(std::floor(20 / period * 2 + 0.5));
        BOOST_REQUIRE(low.found().size() == 2 * static_cast<std::size_t>(crossings));
        for (int k = 0; k < crossings; ++k) {
            const auto &first = low.found()[2 * k], &second = low.found()[2 * k + 1];
            BOOST_TEST(first.event == 0);
            BOOST_TEST(second.event == (k % 2 == 0 ? 2 : 1));
            BOOST_TEST((first.direction == (k % 2 == 0 ? crossing::falling : crossing::rising)));
            BOOST_TEST((first.t == second.t));
            BOOST_TEST(first.t * sense == period * (0.25 + 0.5 * k), within(1e-9));
            BOOST_TEST(std::abs(first.y[0]) < 1e-14);
            BOOST_TEST(std::abs(first.y[1]) == 2 * std::sin(0.5), within(1e-9));
        }
    }
}

// Radial velocity zero: apocentre (distance 1.6) at odd multiples of pi, pericentre (0.4) at even ones.
BOOST_AUTO_TEST_CASE(kepler_passes_its_apsides_every_half_period) {
    for (const double t1 : {16.0, -16.0}) {
        auto apsides = sc::events<Vector4d>(
            sc::event([](double, const Vector4d& y) { return y.head<2>().dot(y.tail<2>()); }));
        const auto r =
            sc::integrate(radau, kepler, pericentre, 0, t1, {.rtol = 1e-10, .atol = 1e-10}, apsides);
        BOOST_TEST(r.ok());
        BOOST_REQUIRE(apsides.found().size() == 5u);  // the one at t = 0 is where the run starts
        for (int k = 1; k <= 5; ++k) {
            const auto& a = apsides.found()[static_cast<std::size_t>(k - 1)];
            BOOST_TEST(std::abs(a.t) == k * pi, within(1e-7));
            BOOST_TEST(a.y.head<2>().norm() == (k % 2 == 1 ? 1.6 : 0.4), within(1e-7));
            BOOST_TEST((a.direction == ((k % 2 == 1) == (t1 > 0) ? crossing::falling : crossing::rising)));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_run_continued_from_an_event_does_not_meet_it_again) {
    const double period = 4 * std::comp_ellint_1(std::sin(0.5));
    for (const int sense : {1, -1}) {
        auto low = sc::events<Vector2d>(sc::event(component(0), {.terminal = true}));
        Vector2d y(1, 0);
        double t = 0;
        for (int k = 0; k < 8; ++k) {
            const auto r = sc::integrate(sc::radau_iia<5>(), pendulum, y, t, sense * 50,
                                         {.rtol = 1e-12, .atol = 1e-12}, low);
            BOOST_TEST(sc::name(r.status) == "event");
            BOOST_TEST(r.t * sense == period * (0.25 + 0.5 * k), within(1e-9));
            t = r.t;
            y = r.y;
        }
    }
}

// The second lies within rounding of the first, before or after it, in the same or in the next part of the step.
BOOST_AUTO_TEST_CASE(an_event_at_the_place_of_a_terminal_one_is_not_lost) {
    for (int k = 0; k < 500; ++k) {
        const double root = 0.1 + 0.8 * std::fmod(k * 0.6180339887498949, 1.0);
        auto watch =
            sc::events<V1>(sc::event(time_minus(root), {.terminal = true}),
                           sc::event([&](double, const V1& y) { return y[0] * y[0] - root * root; }),
                           sc::event([&](double, const V1& y) { return std::exp(y[0]) - std::exp(root); }));
        const auto r = run_clock(0, 1, 0.25, watch);
        BOOST_REQUIRE((r.status == sc::status::event));
        BOOST_TEST(std::abs(r.t - root) < 1e-15);
        int seen[3] = {0, 0, 0};
        for (const auto& o : watch) ++seen[o.event];
        const auto rest = sc::integrate(radau, clock_rate, r.y, r.t, 1, {.fixed_step = 0.25}, watch);
        BOOST_TEST(rest.ok());
        for (const auto& o : watch.found()) ++seen[o.event];
        BOOST_TEST(seen[0] == 1);
        BOOST_TEST(seen[1] == 1);
        BOOST_TEST(seen[2] == 1);
    }
}

BOOST_AUTO_TEST_CASE(an_event_in_the_first_step_is_found_however_large_t1_is) {
    for (const double t1 : {1e6, 1e13}) {
        auto watch = sc::events<V1>(sc::event(time_minus(1e-3), {.terminal = true}));
        const auto r = sc::integrate(radau, clock_rate, V1(0.0), 0, t1, {.initial_step = 0.01}, watch);
        BOOST_TEST(sc::name(r.status) == "event");
        BOOST_TEST(r.t == 1e-3, within(1e-12));
    }
}

// Between two samples: a pair before or after a third crossing, and a pair closer than a 1000th of a sample.
BOOST_AUTO_TEST_CASE(crossings_close_together_are_all_found) {
    for (const bool forth : {true, false})
        for (std::vector<double> roots :
             {std::vector{0.510, 0.515, 0.55}, std::vector{0.52, 0.56, 0.561}, std::vector{0.3, 0.30015}}) {
            auto watch = sc::events<V1>(sc::event([&](double, const V1& y) {
                double product = 1;
                for (const double root : roots) product *= y[0] - root;
                return product;
            }));
            run_clock(forth ? 0 : 1, forth ? 1 : 0, 1, watch);
            BOOST_REQUIRE(watch.found().size() == roots.size());
            if (!forth) std::reverse(roots.begin(), roots.end());
            for (std::size_t k = 0; k < roots.size(); ++k)
                BOOST_TEST(std::abs(watch.found()[k].t - roots[k]) < 4e-16);
        }
}

// One step from 0 to 1 (or back): every zero in the order of the run, two of one function included.
BOOST_AUTO_TEST_CASE(several_events_in_one_step_come_in_the_order_of_the_run) {
    for (const bool forth : {true, false}) {
        auto watch =
            sc::events<V1>(sc::event(time_minus(0.7)), sc::event(time_minus(0.3)),
                           sc::event([](double, const V1& y) { return (y[0] - 0.31) * (y[0] - 0.33); }),
                           sc::event(time_minus(0.32)),
                           sc::event([](double, const V1& y) { return (y[0] - 0.1) * (y[0] - 0.9); }));
        const auto r = run_clock(forth ? 0 : 1, forth ? 1 : 0, 1, watch);
        BOOST_TEST(r.report.steps == 1);
        struct expected {
            int event;
            double t;
        };
        std::vector<expected> all{{4, 0.1}, {1, 0.3}, {2, 0.31}, {3, 0.32}, {2, 0.33}, {0, 0.7}, {4, 0.9}};
        if (!forth) std::reverse(all.begin(), all.end());
        BOOST_REQUIRE(watch.found().size() == all.size());
        for (std::size_t k = 0; k < all.size(); ++k) {
            BOOST_TEST(watch.found()[k].event == all[k].event);
            BOOST_TEST(std::abs(watch.found()[k].t - all[k].t) < 4e-16);
        }
        BOOST_TEST((watch.found()[1].direction == (forth ? crossing::rising : crossing::falling)));
    }
}

BOOST_AUTO_TEST_CASE(the_first_terminal_event_of_a_step_ends_the_run) {
    for (const bool forth : {true, false}) {
        auto watch = sc::events<V1>(
            sc::event(time_minus(0.8), {.terminal = true}), sc::event(time_minus(0.3), {.terminal = true}),
            sc::event(time_minus(0.2)), sc::event(time_minus(0.5)), sc::event(time_minus(0.3)));
        const auto r = run_clock(forth ? 0 : 1, forth ? 1 : 0, 1, watch);
        BOOST_TEST(sc::name(r.status) == "event");
        const double t = forth ? 0.3 : 0.8;
        BOOST_TEST(std::abs(r.t - t) < 4e-16);
        BOOST_TEST(r.y[0] == r.t, within(1e-15));
        BOOST_TEST(watch.found().size() == (forth ? 3u : 1u));
        BOOST_TEST(watch.found().back().t == r.t);
    }
}

// A zero at a sample (0.5), at the end of a step (1) or of the run (2) is reported once; one at the start is
// not.
BOOST_AUTO_TEST_CASE(a_zero_that_is_hit_exactly_is_reported_once_and_not_at_the_start) {
    auto watch = sc::events<V1>(sc::event(time_minus(0)), sc::event(time_minus(0.5)),
                                sc::event(time_minus(1)), sc::event(time_minus(2)));
    const auto r = run_clock(0, 2, 1, watch);
    BOOST_TEST(r.ok());
    BOOST_REQUIRE(watch.found().size() == 3u);
    BOOST_TEST(watch.found()[0].t == 0.5);
    BOOST_TEST(watch.found()[1].t == 1);
    BOOST_TEST(watch.found()[2].t == 2);
}

// From y0 = 0 the function rises and falls again before the first sample.
BOOST_AUTO_TEST_CASE(an_arc_from_the_start_is_not_overlooked) {
    for (const double start : {0.0, -1e-17}) {
        auto watch = sc::events<V1>(sc::event([=](double t, const V1&) { return start + t * (0.05 - t); }));
        run_clock(0, 1, 1, watch);
        BOOST_REQUIRE(watch.found().size() == 1u);
        BOOST_TEST(std::abs(watch.found()[0].t - 0.05) < 1e-15);
        BOOST_TEST((watch.found()[0].direction == crossing::falling));
    }
}

BOOST_AUTO_TEST_CASE(a_touch_counts_and_a_near_miss_does_not) {
    const auto parabola = [](double above) {
        return sc::event([above](double t, const V1&) { return (t - 0.5) * (t - 0.5) + above; });
    };
    auto watch = sc::events<V1>(parabola(0), parabola(1e-12), parabola(-1e-12));
    run_clock(0, 1, 1, watch);
    BOOST_REQUIRE(watch.found().size() == 3u);
    BOOST_TEST(watch.found()[0].event == 2);
    BOOST_TEST(watch.found()[0].t == 0.5 - 1e-6, within(1e-9));
    BOOST_TEST(watch.found()[1].event == 0);
    BOOST_TEST(watch.found()[1].t == 0.5);
    BOOST_TEST(watch.found()[2].t == 0.5 + 1e-6, within(1e-9));
}

// Wherever the samples fall; and a third power is one crossing, not a crossing and a touch.
BOOST_AUTO_TEST_CASE(a_touch_counts_at_every_place_of_a_step) {
    for (int k = 0; k < 100; ++k) {
        const double touched = 0.3 + k * 0.00737;
        const auto power = [touched](int p, double sign) {
            return sc::event([=](double t, const V1&) { return sign * std::pow(t - touched, p); });
        };
        auto watch = sc::events<V1>(power(2, 1), power(2, -1), power(4, 1), power(3, 1));
        run_clock(0, 1.5, 0.4, watch);
        BOOST_TEST_CONTEXT("at " << touched) {
            BOOST_REQUIRE(watch.found().size() == 4u);
            for (const auto& o : watch.found()) BOOST_TEST(std::abs(o.t - touched) < 1e-4);
            for (const auto& o : watch.found())
                if (o.event < 2) BOOST_TEST(std::abs(o.t - touched) < 1e-8);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_function_that_gives_nan_ends_the_run_and_is_named) {
    auto watch = sc::events<V1>(sc::event(time_minus(0.3)),
                                sc::event([](double t, const V1&) { return std::sqrt(2.25 - t) + 1; }));
    const auto r = run_clock(0, 10, 0.5, watch);
    BOOST_TEST(sc::name(r.status) == "function_threw");
    BOOST_TEST(message_of(r.exception).find("event 1 is NaN at t = 2.") != std::string::npos);
    BOOST_TEST(r.t == 2.5);
    BOOST_TEST(watch.found().size() == 1u);

    auto at_once = sc::events<V1>(sc::event([](double t, const V1&) { return std::sqrt(t - 1); }));
    BOOST_TEST(message_of(run_clock(0, 1, 0.5, at_once).exception).find("t = 0") != std::string::npos);
}

// Beyond the wall the function is not defined, but the run ends there.
BOOST_AUTO_TEST_CASE(nan_beyond_a_terminal_event_does_not_matter) {
    auto watch = sc::events<V1>(sc::event([](double, const V1& y) { return std::log(2.1 - y[0]); }),
                                sc::event(time_minus(2.05), {.terminal = true}));
    const auto r = run_clock(0, 10, 1, watch);
    BOOST_TEST(sc::name(r.status) == "event");
    BOOST_TEST(r.t == 2.05, within(1e-15));
    BOOST_TEST(watch.found().front().t == 1.1, within(1e-15));
}

BOOST_AUTO_TEST_CASE(what_an_event_function_throws_is_kept) {
    auto watch = sc::events<V1>(sc::event([](double t, const V1& y) -> double {
        if (t > 1) throw std::domain_error("beyond the table");
        return y[0] + 1;
    }));
    const auto r = run_clock(0, 10, 0.5, watch);
    BOOST_TEST(sc::name(r.status) == "function_threw");
    BOOST_TEST(message_of(r.exception) == "beyond the table");
}

// Several watches and a plain observer side by side: the earliest terminal event decides whatever the order.
BOOST_AUTO_TEST_CASE(watches_compose_in_any_order) {
    auto early = sc::events<V1>(sc::event(time_minus(1.25), {.terminal = true}));
    auto late = sc::events<V1>(sc::event(time_minus(0.75)), sc::event(time_minus(1.75), {.terminal = true}));
    int steps = 0;
    const auto count = [&](double, const V1&) { ++steps; };
    const auto ends_early = [&](auto&& both) {
        const auto r = run_clock(0, 5, 1, both);
        BOOST_TEST(sc::name(r.status) == "event");
        BOOST_TEST(r.t == 1.25);
        BOOST_TEST(r.y[0] == 1.25);
        BOOST_TEST(early.ended());
        BOOST_TEST(!late.ended());
        BOOST_TEST(late.found().size() == 1u);
    };
    ends_early(sc::observers(early, count, late));
    ends_early(sc::observers(late, count, early));
    BOOST_TEST(steps == 4);
}

// Dropped from height 1/2 with g = 1, in either direction of time: on the ground at |t| = 1 with speed 1. The step that shows
// it goes far beyond.
BOOST_AUTO_TEST_CASE(nothing_that_an_observer_keeps_is_later_than_the_end) {
    for (const double t1 : {10.0, -10.0}) {
        const double end = t1 < 0 ? -1 : 1;
        const auto beyond = [&](double t) { return (t - end) * end > 1e-14; };
        auto ground = sc::events<Vector2d>(sc::event(component(0), {.terminal = true}));
        auto deep = sc::events<Vector2d>(
            sc::event([](double, const Vector2d& y) { return y[0] + 1; }, {.terminal = true}),
            sc::event([](double, const Vector2d& y) { return y[0] + 0.5; }));
        std::ostringstream table, lines;
        sc::solution<Vector2d> y;
        sc::output_times<Vector2d> output({0, end / 2, end * 1.25, end * 1.5});
        sc::checkpoint<Vector2d> last;
        double seen = 0, length = 0, covered = 0, part = 0;
        Vector2d state(0, 0);
        auto save = sc::save_every(1, [&](auto point) { last = std::move(point); });
        const auto plain = [&](double t, const Vector2d& x) { seen = t, state = x; };
        const auto timed = [&](double, const Vector2d&, double h) { length += h; };
        const auto continuous = [&](double t, const Vector2d&, double, const auto& out) {
            BOOST_TEST((out(t) - Vector2d(0.5 - t * t / 2, -t)).norm() < 1e-14);
            covered = t;
        };
        auto told = sc::progress([&](double p) { part = p; }, 1e-9);
        const auto check = [&](auto&& all) {
            seen = length = covered = part = 0;
            table.str(""), lines.str(""), last = {};
            const auto r = sc::integrate(radau, free_fall, Vector2d(0.5, 0), 0, t1, {}, all);
            BOOST_TEST(sc::name(r.status) == "event");
            BOOST_TEST(std::abs(r.t - end) < 1e-14);
            BOOST_TEST(r.report.steps < 50);
            BOOST_TEST(!beyond(last.t));
            BOOST_TEST(last.t != 0);
            BOOST_TEST(seen == r.t);
            BOOST_TEST(state == r.y);
            BOOST_TEST(std::abs(length - r.t) < 1e-14);
            BOOST_TEST(covered == r.t);
            BOOST_TEST(std::abs(part - 0.1) < 1e-14);
            BOOST_TEST(y.t1() == r.t);
            BOOST_TEST(y.ends_of_steps().back() == r.t);
            BOOST_TEST(std::abs(y(end * 0.9)[0] - 0.095) < 1e-14);
            BOOST_TEST(output.filled() == 2);
            BOOST_TEST(ground.found().size() == 1u);
            BOOST_TEST(deep.found().size() == 0u);
            const auto last_row = [](std::string text) {
                text.pop_back();
                return text.substr(text.rfind('\n') + 1);
            };
            BOOST_TEST(std::stod(last_row(table.str())) == r.t);
            BOOST_TEST(std::stod(last_row(lines.str()).substr(6)) == r.t);
        };
        auto rows = sc::csv(table, {"q", "v"});
        auto objects = sc::json_lines(lines);
        check(sc::observers(plain, rows, y, deep, save, ground, told, output, timed, continuous, objects));
        check(sc::observers(sc::observers(continuous, deep, objects, save, told), timed,
                            sc::observers(y, output, ground), rows, plain));
    }
}

BOOST_AUTO_TEST_CASE(a_bound_of_the_global_error_is_that_at_the_end) {
    sc::global_error<Vector2d, decltype(free_fall)> error(free_fall, 1, 1);
    auto ground = sc::events<Vector2d>(sc::event(component(0), {.terminal = true}));
    sc::integrate(radau, free_fall, Vector2d(0.5, 0), 0, 10, {}, sc::observers(error, ground));
    BOOST_TEST(error.bound() < 1e-13);  // the solution is exact: the bound is rounding, times e at t = 1
    BOOST_TEST(error.lipschitz_bound() <= (std::numbers::e - 1) * error.largest_defect() * (1 + 1e-12));
}

BOOST_AUTO_TEST_CASE(a_loop_over_steps_shows_its_table_no_more_than_the_run_has) {
    auto ground = sc::events<Vector2d>(sc::event(component(0), {.terminal = true}));
    std::ostringstream table;
    double seen = 0;
    const auto plain = [&](double t, const Vector2d&) { seen = t; };
    auto all = sc::observers(plain, ground, sc::csv(table));
    auto run = sc::steps(radau, free_fall, Vector2d(0.5, 0), 0, 10);
    all.start(0.0, Vector2d(0.5, 0), 10.0);
    for (const auto& step : run)
        if (!all(step.t, step.y, step.h, step.output)) break;
    BOOST_TEST(run.t() > 1.1);
    BOOST_TEST(std::abs(seen - 1) < 1e-14);
    BOOST_TEST(ground.found().back().t == seen);
}

BOOST_AUTO_TEST_CASE(an_observer_that_stops_is_not_an_event) {
    auto watch = sc::events<V1>(sc::event(time_minus(0.5)));
    auto both = sc::observers([](double t, const V1&) { return t < 2; }, watch);
    const auto r = run_clock(0, 5, 1, both);
    BOOST_TEST(sc::name(r.status) == "stopped");
    BOOST_TEST(r.t == 2);
    BOOST_TEST(watch.found().size() == 1u);
}

// Far from zero a function costs its samples and nothing more: 6 per step of Radau IIA(3), and the one at t0.
BOOST_AUTO_TEST_CASE(a_function_far_from_zero_is_evaluated_at_its_samples_only) {
    long calls = 0;
    auto watch = sc::events<V1>(sc::event([&](double, const V1& y) { return ++calls, y[0] + 20; }));
    const auto r = run_clock(0, 10, 0.1, watch);
    BOOST_TEST(calls == 6 * r.report.steps + 1);
    BOOST_TEST(watch.found().empty());
}

// Discontinuous, flat, infinite: narrow() ends where the sign changes, at one of two neighbouring numbers.
BOOST_AUTO_TEST_CASE(a_sign_change_without_a_root_is_narrowed_down_as_well) {
    const double infinity = std::numeric_limits<double>::infinity();
    auto watch =
        sc::events<V1>(sc::event([](double t, const V1&) { return t < 0.6 ? -1.0 : 1.0; }),
                       sc::event([=](double t, const V1&) { return t < 0.61 ? -infinity : infinity; }),
                       sc::event([](double t, const V1&) { return t < 0.62 ? t - 0.62 : 0.0; }),
                       sc::event([](double t, const V1&) { return std::pow(t - 0.63, 9); }));
    run_clock(0, 1, 1, watch);
    BOOST_REQUIRE(watch.found().size() == 4u);
    for (int k = 0; k < 4; ++k) BOOST_TEST(std::abs(watch.found()[k].t - (0.6 + 0.01 * k)) < 3e-16);
}

BOOST_AUTO_TEST_CASE(a_bracket_closes_in_few_evaluations) {
    long calls = 0;
    const auto g = [&](double t) { return ++calls, std::cos(t) - t; };
    sc::time_bracket<double> i{0, g(0), 1, g(1)};
    sc::narrow(g, i, 0x1p-53);
    BOOST_TEST(std::abs(i.b - 0.73908513321516064) < 3e-16);
    BOOST_TEST(calls <= 12);
    calls = 0;
    const auto hard = [&](double t) { return ++calls, t < 1e-9 ? -1e-30 : 1e30; };
    i = {0, -1e-30, 1, 1e30};
    sc::narrow(hard, i, 0x1p-53);
    BOOST_TEST(i.b == 1e-9, within(1e-6));
    BOOST_TEST(calls <= 4 * 53);
}
