// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE changes
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/at.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/save_every.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/observe/table.hpp>
#include <stdexcept>
#include <string>

#include "../message.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;
using sc::at;
using sc::crossing;
using sc::event;

namespace {

const auto radau = sc::radau_iia<3>();
const sc::options<double> fine{.rtol = 1e-10, .atol = 1e-10};

// One type, so that runs of one kind are compiled once.
using right_hand_side = std::function<void(double, const Vector2d&, Vector2d&)>;
using change = std::function<void(double, Vector2d&)>;
using function = std::function<double(double, const Vector2d&)>;
const right_hand_side decay = [](double, const Vector2d& y, Vector2d& f) { f << -y[0], y[0]; };
const right_hand_side fall = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -1; };
const function height = [](double, const Vector2d& y) { return y[0]; };
const change dose = [](double, Vector2d& y) { y[0] += 1; };

auto run(const right_hand_side& f, const Vector2d& y0, double t0, double t1,
         sc::acting_event_watch<Vector2d>& watch) {
    return sc::integrate(radau, f, y0, t0, t1, fine, watch);
}
auto bounce(double restitution, crossing direction = crossing::falling) {
    return sc::events<Vector2d>(
        event(height, {.direction = direction}, change([=](double, Vector2d& y) { y[1] *= -restitution; })));
}
std::string thrown(const std::exception_ptr& e) {
    return message<std::exception>([&] {
        if (e) std::rethrow_exception(e);
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(doses_are_given_at_their_times_and_both_values_are_kept) {
    for (const double step : {0.0, 0.3}) {
        auto o = step > 0 ? sc::options<double>{.fixed_step = step / 10} : fine;
        sc::solution<Vector2d> y;
        sc::output_times<Vector2d> table({0, 1, 2, 2, 3});
        std::ostringstream rows;
        const auto r = sc::integrate(radau, decay, Vector2d(0, 0), 0, 3, o,
                                     sc::observers(at({0.0, 2.0, 3.0}, dose), y, table, sc::csv(rows)));
        BOOST_TEST(r.ok());
        const double e = std::exp(-1.0);
        BOOST_TEST((r.y - Vector2d(1 + e + e * e * e, 2 - e - e * e * e)).norm() < 1e-8);
        BOOST_TEST((y(0) == Vector2d(1, 0) && y.before(0) == Vector2d(0, 0)));
        BOOST_TEST(std::abs(y(1)[0] - e) < 1e-8);
        BOOST_TEST(std::abs(y.before(2)[0] - e * e) < 1e-8);
        BOOST_TEST(std::abs(y(2)[0] - e * e - 1) < 1e-8);
        BOOST_TEST((y(3) == r.y));
        BOOST_TEST((y(3) - y.before(3) - Vector2d(1, 0)).norm() < 1e-14);
        BOOST_TEST((table.filled() == 5 && table.y(0) == Vector2d(1, 0) && table.y(4) == r.y));
        BOOST_TEST((table.y(3) - table.y(2) - Vector2d(1, 0)).norm() < 1e-14);
        long lines = 0, at_two = 0;
        std::istringstream in(rows.str());
        for (std::string line; std::getline(in, line); ++lines) at_two += line.starts_with("2,");
        BOOST_TEST((lines == r.report.steps + 5 && at_two == 2));  // the head, t0, three changes
    }
    // Backwards, and without end.
    const auto back = sc::integrate(radau, decay, Vector2d(1, 0), 2, 0, fine, at({2.0, 1.0}, dose));
    BOOST_TEST(std::abs(back.y[0] - (2 * std::exp(1.0) + 1) * std::exp(1.0)) < 1e-8);
    const auto daily = sc::integrate(radau, decay, Vector2d(0, 0), 0, 2.5, fine, at(sc::every(1.0), dose));
    BOOST_TEST(std::abs(daily.y[0] - std::exp(-0.5) - std::exp(-1.5) - std::exp(-2.5)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(what_acts_at_the_same_time_acts_in_the_order_of_the_arguments) {
    const change twice = [](double, Vector2d& y) { y[0] *= 2; };
    const right_hand_side rest = [](double, const Vector2d&, Vector2d& f) { f.setZero(); };
    const auto end = [&](const change& a, const change& b) {
        return sc::integrate(radau, rest, Vector2d(1, 0), 0, 2, fine,
                             sc::observers(at({1.0}, a), at({1.0, 2.0}, b)))
            .y[0];
    };
    BOOST_TEST(end(dose, twice) == 8);
    BOOST_TEST(end(twice, dose) == 4);
    const auto met = [&](const change& a, const change& b) {
        const function clock = [](double t, const Vector2d&) { return t - 1; };
        auto watch = sc::events<Vector2d>(event(clock, {}, a), event(clock, {}, b));
        const auto r = run(rest, Vector2d(1, 0), 0, 2, watch);
        BOOST_TEST(watch.found().size() == 2u);
        return r.y[0];
    };
    BOOST_TEST(met(dose, twice) == 4);
    BOOST_TEST(met(twice, dose) == 3);
}

BOOST_AUTO_TEST_CASE(a_ball_bounces_at_its_times_and_comes_to_rest_in_a_status) {
    for (const crossing direction : {crossing::falling, crossing::both}) {
        auto watch = bounce(0.8, direction);
        const auto r = run(fall, Vector2d(1, 0), 0, 11, watch);
        BOOST_TEST(r.ok());
        double t = std::sqrt(2.0), v = 0.8 * t;
        for (const auto& o : watch.found()) {
            BOOST_TEST(std::abs(o.t - t) < 1e-9);
            BOOST_TEST((o.direction == crossing::falling));
            t += 2 * v, v *= 0.8;
        }
        BOOST_TEST((t > 11 && t - 2 * v / 0.8 < 11));  // none is found twice, or missed
        const double fallen = 11 - (t - 2 * v / 0.8), up = v / 0.8;
        BOOST_TEST(std::abs(r.y[0] - (up * fallen - fallen * fallen / 2)) < 1e-8);
    }
    auto watch = bounce(0.5);
    const auto r = run(fall, Vector2d(1, 0), 0, 100, watch);
    BOOST_TEST((r.status == sc::status::chattering));
    BOOST_TEST(std::abs(r.t - 3 * std::sqrt(2.0)) < 1e-9);
    BOOST_TEST((std::abs(r.y[0]) < 1e-12 && watch.found().size() < 60));
    BOOST_TEST(watch.alternating() == std::vector<int>{0});
    BOOST_TEST(thrown(r.exception).starts_with("events: event 0 takes place again and again at t = 4.24"));
}

BOOST_AUTO_TEST_CASE(switches_by_parameters_that_the_problem_holds_by_reference) {
    double heat = 1;
    const right_hand_side house = [&](double, const Vector2d& y, Vector2d& f) { f << heat - y[0], 1; };
    const auto thermostat = [&](double low, double high) {
        return sc::events<Vector2d>(
            event([=](double, const Vector2d& y) { return y[0] - high; }, {.direction = crossing::rising},
                  change([&](double, Vector2d&) { heat = -1; })),
            event([=](double, const Vector2d& y) { return y[0] - low; }, {.direction = crossing::falling},
                  change([&](double, Vector2d&) { heat = 1; })));
    };
    auto watch = thermostat(-0.5, 0.5);
    const auto r = run(house, Vector2d(0, 0), 0, 4, watch);
    BOOST_TEST(r.ok());
    BOOST_REQUIRE(watch.found().size() == 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        BOOST_TEST(std::abs(watch.found()[k].t - std::log(2.0) - static_cast<double>(k) * std::log(3.0)) <
                   5e-8);
        BOOST_TEST(watch.found()[k].event == static_cast<int>(k % 2));
    }
    // Without hysteresis it slides: a status after a few of them, and not a run without end or on a wrong side.
    heat = 1;
    auto sliding = thermostat(0.5, 0.5);
    const auto s = run(house, Vector2d(0, 0), 0, 4, sliding);
    BOOST_TEST((s.status == sc::status::chattering));
    BOOST_TEST(std::abs(s.t - std::log(2.0)) < 5e-8);
    BOOST_TEST(sliding.found().size() <= 10u);
    BOOST_TEST((sliding.alternating() == std::vector<int>{0, 1}));
    BOOST_TEST(thrown(s.exception).starts_with("events: events 0 and 1 take place again and again"));
}

BOOST_AUTO_TEST_CASE(what_a_change_carries_over_zero_has_not_crossed_it) {
    auto watch = sc::events<Vector2d>(event([](double, const Vector2d& y) { return y[0] - 0.5; }));
    const auto r =
        sc::integrate(radau, decay, Vector2d(1, 0), 0, 3, fine, sc::observers(watch, at({1.0}, dose)));
    BOOST_TEST(r.ok());
    BOOST_REQUIRE(watch.found().size() == 2u);  // before the dose, and behind it
    BOOST_TEST(std::abs(watch.found()[0].t - std::log(2.0)) < 5e-8);
    BOOST_TEST(std::abs(watch.found()[1].t - 1 - std::log(2 * (1 + std::exp(-1.0)))) < 5e-8);
}

BOOST_AUTO_TEST_CASE(a_run_goes_on_from_a_checkpoint_at_a_dose_without_giving_it_again) {
    std::vector<sc::checkpoint<Vector2d>> points;
    const auto r = sc::integrate(
        radau, decay, Vector2d(0, 0), 0, 3, fine,
        sc::observers(at({0.0, 1.0, 2.0}, dose), sc::save_every(1, [&](auto p) { points.push_back(p); })));
    for (const auto& point : points) {
        const auto rest = sc::integrate(radau, decay, point, 3, {}, at(sc::every(1.0), dose));
        BOOST_TEST((rest.y == r.y || std::abs(rest.y[0] - r.y[0] - 1) < 1e-14));  // that of t = 3
        BOOST_TEST(rest.report.f == r.report.f);
    }
}

BOOST_AUTO_TEST_CASE(events_at_the_start_if_asked_for) {
    const auto found = [&](bool asked, double y0) {
        auto watch = sc::events<Vector2d>(event(height, {.at_start = asked}));
        BOOST_TEST(sc::integrate(radau, fall, Vector2d(y0, 1), 0, 1, fine, watch).ok());
        return watch.found().size();
    };
    BOOST_TEST((found(true, 0) == 1 && found(false, 0) == 0 && found(true, 0.1) == 0));
    auto last = sc::events<Vector2d>(event(height, {.terminal = true, .at_start = true}));
    const auto r = sc::integrate(radau, fall, Vector2d(0, 1), 0, 1, fine, last);
    BOOST_TEST(
        (r.status == sc::status::event && r.t == 0 && r.report.steps == 0 && last.found().size() == 1));
    auto kick = sc::events<Vector2d>(event(height, {.direction = crossing::falling, .at_start = true},
                                           change([](double, Vector2d& y) { y[1] = 1; })));
    BOOST_TEST(std::abs(run(fall, Vector2d(0, 0), 0, 1, kick).y[0] - 0.5) < 1e-9);
    BOOST_TEST(kick.found().size() == 1u);
}

BOOST_AUTO_TEST_CASE(bad_changes_leave_the_state_before_them) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const change spoil = [=](double, Vector2d& y) { y[0] = nan; };
    const change fail = [](double, Vector2d&) { throw std::runtime_error("no more"); };
    const auto r = sc::integrate(radau, decay, Vector2d(1, 0), 0, 3, fine, at({2.0}, spoil));
    BOOST_TEST((r.status == sc::status::function_threw && r.t == 2));
    BOOST_TEST(std::abs(r.y[0] - std::exp(-2.0)) < 1e-9);
    BOOST_TEST(thrown(r.exception) == "at: the action must leave y finite and of the same size, at t = 2");
    const auto s = sc::integrate(radau, decay, Vector2d(1, 0), 0, 3, fine, at({0.0}, fail));
    BOOST_TEST((s.status == sc::status::function_threw && s.t == 0 && s.y[0] == 1));
    BOOST_TEST(thrown(s.exception) == "no more");
    auto watch = sc::events<Vector2d>(event([](double t, const Vector2d&) { return t - 1.25; }, {}, spoil));
    const auto u = run(decay, Vector2d(1, 0), 0, 3, watch);
    BOOST_TEST((u.status == sc::status::function_threw && std::abs(u.t - 1.25) < 1e-15));
    BOOST_TEST(std::abs(u.y[0] - std::exp(-1.25)) < 1e-8);
    BOOST_TEST(thrown(u.exception).starts_with("event: the action of event 0 must leave y finite"));
    // Terminal: by itself it is refused; beside an action nothing is done.
    BOOST_TEST(
        message([&] { event(height, {.terminal = true}, dose); }) ==
        "event: a terminal event ends the run and leaves nothing to be done: give .terminal or an action");
    const function clock = [](double t, const Vector2d&) { return t - 1; };
    auto both = sc::events<Vector2d>(event(clock, {}, dose), event(clock, {.terminal = true}));
    const auto v = run(decay, Vector2d(1, 0), 0, 3, both);
    BOOST_TEST((v.status == sc::status::event && both.found().size() == 2u));
    BOOST_TEST(std::abs(v.y[0] - std::exp(-1.0)) < 1e-8);
    const auto refused = [&](const sc::break_times<double>& times) {
        return message([&] { sc::integrate(radau, decay, Vector2d(1, 0), 0, 3, fine, at(times, dose)); });
    };
    BOOST_TEST(refused({1.0, 1.0}) == "at: times must be in order, each one once");
    BOOST_TEST(refused({1.0, 4.0}) == "at: times must lie between t0 and t1");
    BOOST_TEST(refused({nan}) == "at: times must be finite");
    BOOST_TEST(refused({}) == "no exception");
}
