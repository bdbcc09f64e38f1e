// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE relaxation
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/explicit.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/relaxation.hpp>
#include <stdexcept>
#include <vector>

#include "../message.hpp"
#include "interrupt.hpp"

// Relaxed methods: what they keep, their order, where they end (Ketcheson 2019, whose nonlinear oscillator this is).

using namespace stagecraft;
using Eigen::Vector2d;

namespace {

const auto oscillator = [](double, const Vector2d& y, Vector2d& f) {
    f << -y[1], y[0];
    f /= y.squaredNorm();
};
const auto square = [](const auto& y) { return y[0] * y[0] + y[1] * y[1]; };
const Vector2d start(1, 0);
Vector2d on_circle(double t) { return {std::cos(t), std::sin(t)}; }

const auto pendulum = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -std::sin(y[0]); };
const auto energy = [](const Vector2d& y) { return y[1] * y[1] / 2 - std::cos(y[0]); };

/// y' = -|y|^2 y, whose square falls: y = y0 / sqrt(1 + 2 t |y0|^2).
const auto braked = [](double, const Vector2d& y, Vector2d& f) { f = -y.squaredNorm() * y; };

}  // namespace

BOOST_AUTO_TEST_CASE(equal_steps_keep_an_invariant_and_their_order) {
    double before = 0;
    for (const double h : {0.1, 0.05, 0.025}) {
        const auto r = integrate(relaxation(classical_rk4(), square), oscillator, start, 0, 10,
                                 options<double>{.fixed_step = h});
        BOOST_REQUIRE(r.ok());
        BOOST_TEST(r.t == 10);
        BOOST_TEST(r.report.steps == std::lround(10 / h));
        BOOST_TEST(r.report.f == 4 * r.report.steps);
        BOOST_TEST(std::abs(square(r.y) - 1) < 1e-14);
        const double error = (r.y - on_circle(10)).norm();
        if (before > 0) BOOST_TEST(std::abs(std::log2(before / error) - 4) < 0.1);
        before = error;
    }
}

BOOST_AUTO_TEST_CASE(adaptive_steps_keep_it_for_a_thousand_radians) {
    const options<double> o{.rtol = 1e-6, .atol = 1e-6};
    const auto plain = integrate(dormand_prince_5_4(), oscillator, start, 0, 1000, o);
    const auto relaxed = integrate(relaxation(dormand_prince_5_4(), square), oscillator, start, 0, 1000, o);
    BOOST_TEST(std::abs(square(plain.y) - 1) > 1e-5);
    BOOST_TEST(std::abs(square(relaxed.y) - 1) < 1e-13);
    const auto error = [](const auto& r) { return (r.y - on_circle(1000)).norm(); };
    BOOST_TEST(error(relaxed) < error(plain) / 10);
    BOOST_TEST(relaxed.report.f < 1.2 * plain.report.f);  // the slope at the end of a step is evaluated
}

BOOST_AUTO_TEST_CASE(a_dissipated_quantity_falls_as_it_should) {
    double before = 0;
    for (const double h : {0.1, 0.05, 0.025}) {
        double last = 1;
        const auto falls = [&](double, const Vector2d& y) {
            BOOST_TEST(square(y) < last);
            last = square(y);
        };
        const auto r = integrate(relaxation(classical_rk4(), square), braked, start, 0, 3,
                                 options<double>{.fixed_step = h}, falls);
        BOOST_REQUIRE(r.ok());
        const double error = std::abs(r.y[0] - 1 / std::sqrt(7));
        if (before > 0) BOOST_TEST(std::abs(std::log2(before / error) - 4) < 0.3);
        before = error;
    }
    // A function of numbers alone stands for an invariant, which this is not: no step keeps it.
    const auto kept = [](const Vector2d& y) { return y.squaredNorm(); };
    const auto r = integrate(relaxation(dormand_prince_5_4(), kept), braked, start, 0, 3);
    BOOST_TEST(!r.ok());
    BOOST_TEST(r.y == start);
}

BOOST_AUTO_TEST_CASE(diagonally_implicit_methods_and_other_invariants) {
    const Vector2d from(2, 0);
    const auto trapezoidal = lobatto_iiia<2>();
    const options<double> o{.rtol = 1e-10, .fixed_step = 0.1};
    const auto plain = integrate(trapezoidal, pendulum, from, 0, 100, o);
    const auto relaxed = integrate(relaxation(trapezoidal, energy), pendulum, from, 0, 100, o);
    BOOST_REQUIRE(relaxed.ok());
    BOOST_TEST(std::abs(energy(plain.y) - energy(from)) > 1e-8);
    BOOST_TEST(std::abs(energy(relaxed.y) - energy(from)) < 1e-14);
    // At rest there is nothing to relax.
    const auto rest = integrate(relaxation(dormand_prince_5_4(), energy), pendulum, Vector2d(0, 0), 0, 10);
    BOOST_TEST(rest.ok());
    BOOST_TEST(rest.y == Vector2d(0, 0));
}

BOOST_AUTO_TEST_CASE(break_points_outputs_and_changes_of_direction) {
    std::vector<double> times;
    double error = 0;
    const auto look = [&](double t, const Vector2d&, double h, const auto& output) {
        times.push_back(t);
        error = std::max(error, (output(t - h / 2) - on_circle(t - h / 2)).norm());
    };
    options<double> o{.rtol = 1e-8, .atol = 1e-8};
    o.break_points = {1.5, 4.25};
    const auto r = integrate(relaxation(dormand_prince_5_4(), square), oscillator, start, 0, 10, o, look);
    BOOST_TEST(r.ok());
    for (const double t : {1.5, 4.25, 10.0}) BOOST_TEST(std::count(times.begin(), times.end(), t) == 1);
    BOOST_TEST(error < 1e-5);  // of a cubic
    const auto back = integrate(relaxation(dormand_prince_5_4(), square), oscillator, r.y, 10, 0, o);
    BOOST_TEST((back.y - start).norm() < 1e-6);
    BOOST_TEST(std::abs(square(back.y) - 1) < 1e-14);
}

BOOST_AUTO_TEST_CASE(a_run_goes_on_from_a_checkpoint_with_its_bits) {
    interrupted::at_five_places(relaxation(dormand_prince_5_4(), square), oscillator, start, 10.0,
                                {.rtol = 1e-6, .atol = 1e-6});
}

BOOST_AUTO_TEST_CASE(the_factor_is_the_root_next_to_one) {
    const auto root_at = [](double x) { return [x](double g) { return 1e-4 * g * (g - x); }; };
    BOOST_TEST(relaxation_factor(1.0, root_at(1.01)) == 1.01, boost::test_tools::tolerance(1e-10));
    BOOST_TEST(relaxation_factor(1.0, root_at(0.75)) == 0.75, boost::test_tools::tolerance(1e-10));
    BOOST_TEST(relaxation_factor(1.0, [](double) { return 3e-16; }) == 1.0);
    BOOST_TEST(std::isnan(relaxation_factor(1.0, root_at(1.7))));
    BOOST_TEST(std::isnan(relaxation_factor(1.0, [](double) { return 1e-3; })));
    BOOST_TEST(std::isnan(relaxation_factor(1.0, [](double) { return std::nan(""); })));
}

BOOST_AUTO_TEST_CASE(what_it_cannot_serve_is_named) {
    const auto run = [](const auto& method, const auto& problem) {
        return message([&] { integrate(method, problem, start, 0, 1, options<double>{.fixed_step = 0.1}); });
    };
    const double infinity = std::numeric_limits<double>::infinity();
    BOOST_TEST(run(relaxation(classical_rk4(), [=](const Vector2d&) { return infinity; }), oscillator)
                   .find("eta must be finite at y0") != std::string::npos);
    BOOST_TEST(run(relaxation(lobatto_iiia<3>(), square), oscillator).find("must follow one another") !=
               std::string::npos);
    BOOST_TEST(run(relaxation(classical_rk4(), square),
                   with_mass(oscillator, Eigen::Matrix2d(Eigen::Vector2d(1, 2).asDiagonal())))
                   .find("without a mass matrix") != std::string::npos);
}
