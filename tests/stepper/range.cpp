// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE range
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/steps.hpp>
#include <stdexcept>
#include <vector>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

const auto radau = sc::radau_iia<3>();

// y = (sin t, cos t); an lvalue, which the range refers to.
const auto circle = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -y[0]; };

}  // namespace

BOOST_AUTO_TEST_CASE(the_range_takes_the_steps_of_integrate) {
    for (const double t1 : {5.0, -5.0}) {
        std::vector<double> t;
        const auto r = sc::integrate(radau, circle, Vector2d(0, 1), 0, t1, {},
                                     [&](double at, const Vector2d&) { t.push_back(at); });
        auto run = sc::steps(radau, circle, Vector2d(0, 1), 0, t1);
        std::size_t k = 0;
        double before = 0;
        for (const auto& step : run) {
            BOOST_REQUIRE(k < t.size());
            BOOST_TEST(step.t == t[k++]);
            BOOST_TEST(step.h == step.t - before, boost::test_tools::tolerance(1e-13));
            BOOST_TEST(std::abs(step.y[0] - std::sin(step.t)) < 1e-4);
            const double middle = before + step.h / 2;
            BOOST_TEST(std::abs(step.output(middle)[0] - std::sin(middle)) < 1e-4);
            BOOST_TEST(run.report().steps == static_cast<long>(k));
            before = step.t;
        }
        BOOST_TEST(k == t.size());
        BOOST_TEST(sc::name(run.status()) == "success");
        BOOST_TEST(run.t() == t1);
        BOOST_TEST((run.y() == r.y));
        BOOST_TEST(run.report().f == r.report.f);
    }
}

BOOST_AUTO_TEST_CASE(a_step_comes_apart_and_a_temporary_range_lives_through_its_loop) {
    double last = 0, sum = 0;
    for (const auto& [t, y, h, output] : sc::steps(radau, circle, Vector2d(0, 1), 0, 1)) {
        last = y[0];
        sum += h;
    }
    BOOST_TEST(last == std::sin(1.0), boost::test_tools::tolerance(1e-5));
    BOOST_TEST(sum == 1, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(algorithms_take_the_range) {
    auto run = sc::steps(radau, circle, Vector2d(0, 1), 0, 100);
    static_assert(std::ranges::input_range<decltype(run)>);
    const auto negative = std::ranges::find_if(run, [](const auto& step) { return step.y[0] < 0; });
    BOOST_REQUIRE((negative != run.end()));
    BOOST_TEST((*negative).t > std::acos(-1.0));
    BOOST_TEST((*negative).output.t0() < std::acos(-1.0));
    auto longest = sc::steps(radau, circle, Vector2d(0, 1), 0, 10);
    double h = 0;
    std::ranges::for_each(longest, [&](const auto& step) { h = std::max(h, step.h); });
    BOOST_TEST(h == longest.report().largest_step);
}

BOOST_AUTO_TEST_CASE(a_loop_left_early_is_no_success_and_can_be_taken_up_again) {
    auto run = sc::steps(radau, circle, Vector2d(0, 1), 0, 10);
    for (const auto& step : run)
        if (step.t > 3) break;
    BOOST_TEST(sc::name(run.status()) == "stopped");
    const double left = run.t();
    BOOST_TEST(left < 10);
    bool first = true;
    for (const auto& step : run) {
        if (first) BOOST_TEST(step.t == left);  // the step that the loop before has not finished with
        first = false;
    }
    BOOST_TEST(sc::name(run.status()) == "success");
    BOOST_TEST(run.y()[0] == std::sin(10.0), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(a_run_without_steps_is_an_empty_range) {
    auto none = sc::steps(radau, circle, Vector2d(0, 1), 2, 2);
    BOOST_TEST((none.begin() == none.end()));
    BOOST_TEST(sc::name(none.status()) == "success");
    auto stuck = sc::steps(radau, circle, Vector2d(0, 1), 0, 10, {.max_steps = 3});
    BOOST_TEST(std::ranges::count_if(stuck, [](const auto&) { return true; }) <= 3);
    BOOST_TEST(sc::name(stuck.status()) == "too_many_steps");
}

BOOST_AUTO_TEST_CASE(errors_leave_the_loop_and_bad_arguments_the_call) {
    BOOST_CHECK_THROW(sc::steps(radau, circle, Vector2d(0, 1), 0, 1, {.rtol = -1}), std::invalid_argument);
    const auto breaks = [](double t, const Vector2d& y, Vector2d& f) {
        if (t > 1) throw std::domain_error("beyond the table");
        f = -y;
    };
    auto run = sc::steps(radau, breaks, Vector2d(1, 2), 0, 2);
    BOOST_CHECK_THROW(std::ranges::for_each(run, [](const auto&) {}), std::domain_error);
    BOOST_TEST(run.t() <= 1);
    BOOST_TEST(run.y()[0] == std::exp(-run.t()), boost::test_tools::tolerance(1e-4));
    BOOST_TEST(sc::name(run.status()) == "stopped");
}

BOOST_AUTO_TEST_CASE(an_observer_may_be_called_by_hand) {
    auto watch =
        sc::events<Vector2d>(sc::event([](double, const Vector2d& y) { return y[0]; }, {.terminal = true}));
    for (const auto& step : sc::steps(radau, circle, Vector2d(0, 1), 0, 100, {.rtol = 1e-10, .atol = 1e-10}))
        if (!watch(step.t, step.y, step.h, step.output)) break;
    BOOST_REQUIRE(watch.ended());
    BOOST_TEST(watch.found().back().t == std::acos(-1.0), boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(a_correction_is_made_before_the_step_is_seen_as_in_integrate) {
    const auto unit = [](const auto&, const auto& y, auto& g) {
        g[0] = (y[0] * y[0] + y[1] * y[1] - 1.0) / 2.0;
    };
    auto keep = sc::projection_onto<1>(unit);
    const auto r = sc::integrate(radau, circle, Vector2d(0, 1), 0, 20, {}, keep);
    const long corrections = keep.corrections();
    double drift = 0, gap = 0;
    auto run = sc::steps(radau, circle, Vector2d(0, 1), 0, 20, {}, keep);
    for (const auto& step : run) {
        drift = std::max(drift, std::abs(step.y.norm() - 1));
        gap = std::max(gap, (step.output(step.t) - step.y).norm());
    }
    BOOST_TEST(sc::name(run.status()) == "success");
    BOOST_TEST((run.y() == r.y));
    BOOST_TEST(drift < 1e-15);
    BOOST_TEST(gap < 1e-14);
    BOOST_TEST(corrections > 10);
    BOOST_TEST(keep.corrections() == 2 * corrections);
    // A temporary lives as long as the range; without a correction the norm drifts.
    double kept = 0, lost = 0;
    for (const auto& step : sc::steps(radau, circle, Vector2d(0, 1), 0, 20, {}, sc::projection_onto<1>(unit)))
        kept = std::max(kept, std::abs(step.y.norm() - 1));
    for (const auto& step : sc::steps(radau, circle, Vector2d(0, 1), 0, 20))
        lost = std::max(lost, std::abs(step.y.norm() - 1));
    BOOST_TEST(kept < 1e-15);
    BOOST_TEST(lost > 1e-6);
    // What a correction throws leaves the loop.
    const auto nowhere = [](double, const Vector2d& y, Eigen::Matrix<double, 1, 1>& g) {
        g[0] = y.squaredNorm() + 1;
    };
    auto stuck = sc::steps(radau, circle, Vector2d(0, 1), 0, 20, {}, sc::projection_onto<1>(nowhere));
    BOOST_CHECK_THROW(std::ranges::for_each(stuck, [](const auto&) {}), std::domain_error);
    BOOST_TEST(sc::name(stuck.status()) == "stopped");
}

BOOST_AUTO_TEST_CASE(no_observer_among_several_is_none) {
    long calls = 0;
    const auto count = [&](double, const Vector2d&) { ++calls; };
    sc::no_observer none;
    const auto r =
        sc::integrate(radau, circle, Vector2d(0, 1), 0, 5, {}, sc::observers(none, count, sc::no_observer{}));
    BOOST_TEST(r.ok());
    BOOST_TEST(calls == r.report.steps);
}
