// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE output_times
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stdexcept>
#include <string>

#include "../message.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

const auto radau = sc::radau_iia<3>();
const sc::options<double> tight{.rtol = 1e-10, .atol = 1e-10};

// y = (sin t, cos t)
const auto circle = [](double, const auto& y, auto& f) { f << y[1], -y[0]; };

// One problem type for fixed and dynamic states.
template <class Vector>
auto run(double t0, double t1, sc::output_times<Vector>& table) {
    const Vector y0 = Vector2d(std::sin(t0), std::cos(t0));
    return sc::integrate(radau, circle, y0, t0, t1, tight, table);
}

template <class Vector>
void check(double t0, double t1, const std::vector<double>& times) {
    sc::output_times<Vector> table(times, true);
    const auto r = run(t0, t1, table);
    BOOST_TEST(r.ok());
    BOOST_REQUIRE(table.filled() == static_cast<int>(times.size()));
    for (int i = 0; i < table.filled(); ++i) {
        const double t = times[static_cast<std::size_t>(i)];
        BOOST_TEST(table.time(i) == t);
        BOOST_TEST(std::abs(table.y(i)[0] - std::sin(t)) < 1e-8);
        BOOST_TEST(std::abs(table.y(i)[1] - std::cos(t)) < 1e-8);
        BOOST_TEST(std::abs(table.derivative(i)[0] - std::cos(t)) < 1e-6);
        BOOST_TEST(std::abs(table.derivative(i)[1] + std::sin(t)) < 1e-6);
    }
    BOOST_TEST((table.y(0) == Vector2d(std::sin(t0), std::cos(t0))));
    BOOST_TEST((table.y(table.filled() - 1) == r.y));
    BOOST_TEST(table.values().cols() == table.filled());
    // Asking costs no step.
    const Vector y0 = Vector2d(std::sin(t0), std::cos(t0));
    const auto plain = sc::integrate(radau, circle, y0, t0, t1, tight);
    BOOST_TEST(plain.report.steps == r.report.steps);
    BOOST_TEST(plain.report.f == r.report.f);
    BOOST_TEST((plain.y == r.y));
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_are_there_at_every_time_asked_for_in_both_directions_of_time) {
    const std::vector<double> times{0, 1e-9, 0.5, 0.5, 0.50001, 2, 7.5, 10};
    const std::vector<double> reversed(times.rbegin(), times.rend());
    check<Vector2d>(0, 10, times);
    check<Vector2d>(10, 0, reversed);
    check<VectorXd>(0, 10, times);
}

BOOST_AUTO_TEST_CASE(times_out_of_order_or_out_of_the_interval_are_refused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto table = [](std::vector<double> times, double t0, double t1) {
        return message([&] {
            sc::output_times<Vector2d> t(times);
            run(t0, t1, t);
        });
    };
    BOOST_TEST(table({0, 1}, 0, 1) == "no exception");
    BOOST_TEST(table({}, 0, 1) == "no exception");
    BOOST_TEST(table({0, 1, 0.5}, 0, 1) == "output_times: times must be in order");
    BOOST_TEST(table({0, nan}, 0, 1) == "output_times: times must be finite");
    BOOST_TEST(table({0.5, 1.5}, 0, 1) == "output_times: times must be between t0 and t1");
    BOOST_TEST(table({-0.5, 0.5}, 0, 1) == "output_times: times must be between t0 and t1");
    BOOST_TEST(table({1, 0}, 0, 1) == "output_times: times must be in the order of the run");
    BOOST_TEST(table({0, 1}, 1, 0) == "output_times: times must be in the order of the run");
    BOOST_TEST(table({1, 0}, 1, 0) == "no exception");
    sc::output_times<Vector2d> with_slopes({1, 1}, true);
    BOOST_TEST(message([&] { run(1, 1, with_slopes); }) ==
               "output_times: a run from t0 to t0 has no derivatives");
}

BOOST_AUTO_TEST_CASE(a_run_without_a_step_gives_its_initial_value) {
    sc::output_times<Vector2d> table({3, 3});
    run(3, 3, table);
    BOOST_TEST(table.filled() == 2);
    BOOST_TEST(table.y(1)[0] == std::sin(3.0));
}

BOOST_AUTO_TEST_CASE(a_run_that_ends_early_fills_what_it_has_reached) {
    sc::output_times<Vector2d> table({0, 1, 2, 3, 4, 5});
    auto top =
        sc::events<Vector2d>(sc::event([](double, const Vector2d& y) { return y[1]; }),
                             sc::event([](double, const Vector2d& y) { return y[0]; }, {.terminal = true}));
    const auto r =
        sc::integrate(radau, circle, Vector2d(0, 1), 0, 5, tight, sc::observers(table, top));  // to t = pi
    BOOST_TEST(sc::name(r.status) == "event");
    BOOST_TEST(table.filled() == 4);
    BOOST_TEST(std::abs(table.y(3)[0] - std::sin(3.0)) < 1e-8);
    BOOST_CHECK_THROW(table.y(4), std::out_of_range);
    BOOST_CHECK_THROW(table.y(-1), std::out_of_range);
    BOOST_CHECK_THROW(table.derivative(0), std::out_of_range);
    // The same table serves the next run.
    BOOST_TEST(run(0, 5, table).ok());
    BOOST_TEST(table.filled() == 6);
}

BOOST_AUTO_TEST_CASE(a_failing_run_fills_nothing_beyond_its_last_state) {
    const auto breaks = [](double t, const Vector2d& y, Vector2d& f) {
        if (t > 2.5) throw std::domain_error("beyond the table");
        f << y[1], -y[0];
    };
    sc::output_times<Vector2d> table({0, 1, 2, 3});
    const auto r = sc::integrate(radau, breaks, Vector2d(0, 1), 0, 5, tight, table);
    BOOST_TEST(sc::name(r.status) == "function_threw");
    BOOST_TEST(r.t > 2);
    BOOST_TEST(table.filled() == 3);
}

BOOST_AUTO_TEST_CASE(a_run_that_fails_in_its_first_step_has_reached_t0) {
    const auto breaks = [](double t, const Vector2d& y, Vector2d& f) {
        if (t > 1) throw std::domain_error("beyond the table");
        f << y[1], -y[0];
    };
    for (const bool slopes : {false, true}) {
        sc::output_times<Vector2d> table({1, 1, 1.5}, slopes);
        const auto r = sc::integrate(radau, breaks, Vector2d(0, 1), 1, 5, tight, table);
        BOOST_TEST(sc::name(r.status) == "function_threw");
        BOOST_TEST(r.report.steps == 0);
        BOOST_TEST(table.filled() == 2);
        BOOST_TEST((table.y(1) == Vector2d(0, 1)));
        BOOST_CHECK_THROW(table.y(2), std::out_of_range);
        BOOST_CHECK_THROW(table.derivative(0), std::out_of_range);  // which only a step gives
    }
    // where t0 was not asked for nothing is reached
    sc::output_times<Vector2d> later({1.25, 1.5});
    sc::integrate(radau, breaks, Vector2d(0, 1), 1, 5, tight, later);
    BOOST_TEST(later.filled() == 0);
}
