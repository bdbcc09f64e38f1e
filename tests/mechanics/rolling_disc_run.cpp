// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE rolling_disc_run
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>

#include <problems/rolling_disc/measure.hpp>

using namespace rolling_disc;

namespace {

const auto nothing = [](double, const auto&) {};

state reference(const std::string& t) {
    return reference_solution(STAGECRAFT_SOURCE_DIR "/examples/problems/rolling_disc/data/disc.json", t);
}

run disc_run(double tolerance) { return observe(stagecraft::radau_iia<3>(), disc<>{}, tolerance, nothing); }

}  // namespace

BOOST_AUTO_TEST_CASE(the_tightest_run_meets_its_bounds) {
    const run r = disc_run(1e-12);
    BOOST_REQUIRE(r.status == stagecraft::status::success);
    BOOST_TEST(r.error_y(reference("1.0")) < 1e-10);
    BOOST_TEST(r.error_lambda(reference("1.0")) < 1e-7);
    BOOST_TEST(r.largest_violation() < 1e-12);
    BOOST_TEST(r.largest_drift() < 1e-9);
    BOOST_TEST(r.steps.size() == static_cast<std::size_t>(r.report.steps));
    BOOST_TEST(r.steps.back().t == 1.0);
}

BOOST_AUTO_TEST_CASE(errors_follow_the_tolerance) {
    // From 1e-4 to 1e-12 the error must fall by at least a factor 2 per decade and never exceed 200 tol. It is
    // the larger one of two ends: that of a single one passes through zero.
    const state half = reference("0.5"), exact = reference("1.0");
    const auto dae = stagecraft::index_2(disc<>{});
    const state start = dae.initial_state(initial_position(), initial_velocity());
    double last = 1;
    for (int digits = 4; digits <= 12; ++digits) {
        const double tolerance = std::pow(10.0, -digits);
        const run r = disc_run(tolerance);
        BOOST_REQUIRE(r.status == stagecraft::status::success);
        const auto first = stagecraft::integrate(stagecraft::radau_iia<3>(), dae, start, 0.0, 0.5,
                                                 {.rtol = tolerance, .atol = tolerance});
        BOOST_REQUIRE(first.ok());
        const double error = std::max(r.error_y(exact), (first.y - half).head<10>().cwiseAbs().maxCoeff());
        BOOST_TEST(error < last / 2);
        BOOST_TEST(error < 200 * tolerance);
        last = error;
    }
}

BOOST_AUTO_TEST_CASE(the_solution_in_between_has_the_reference_digits) {
    const state tenth = reference("0.1"), half = reference("0.5");
    double error_tenth = 1, error_half = 1;
    observe(stagecraft::radau_iia<3>(), disc<>{}, 1e-12, [&](double t, const auto& output) {
        const auto error = [&](double time, const state& exact) {
            const state y = output(time);
            return (y - exact).head<10>().cwiseAbs().maxCoeff();
        };
        if (output.t0() < 0.1 && 0.1 <= t) error_tenth = error(0.1, tenth);
        if (output.t0() < 0.5 && 0.5 <= t) error_half = error(0.5, half);
    });
    // The collocation polynomial is of order s = 3 within a step, where the end points are of order 5.
    BOOST_TEST(error_tenth < 1e-9);
    BOOST_TEST(error_half < 1e-8);
}

BOOST_AUTO_TEST_CASE(the_printed_force_loses_energy) {
    disc<> printed;
    printed.printed_force = true;
    const auto drift_to_quarter = [](const disc<>& body) {
        double drift = 0;
        for (const auto& s : observe(stagecraft::radau_iia<3>(), body, 1e-10, nothing).steps)
            if (s.t <= 0.25) drift = std::max(drift, std::abs(s.drift));
        return drift;
    };
    BOOST_TEST(drift_to_quarter(printed) > 1e-2);
    BOOST_TEST(drift_to_quarter(disc<>{}) < 1e-9);
}
