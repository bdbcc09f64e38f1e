// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE classes
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

// Every guard shows the class of problems that it protects: runs of that class with it and without it, against closed forms.
// One type of state, so that a further class costs a right-hand side.

namespace sc = stagecraft;
using Eigen::VectorXd;

namespace {

/// The largest error at the end of a run, in tolerances; infinite where it has failed.
template <class Method, class F>
double error_of(const Method& method, const F& f, const VectorXd& y0, double t1, double tol,
                const VectorXd& exact) {
    const auto r = sc::integrate(method, f, y0, 0.0, t1, {.rtol = tol, .atol = tol});
    if (r.status != sc::status::success) return INFINITY;
    return ((r.y - exact).array().abs() / (tol + tol * exact.array().abs())).maxCoeff();
}

VectorXd state(std::initializer_list<double> x) {
    return VectorXd::Map(x.begin(), static_cast<Eigen::Index>(x.size()));
}

/// How many of `runs` runs end with more than `most` tolerances: with(run) and without(run) are their errors.
struct outcome {
    int with = 0, without = 0;
};
template <class Run>
outcome count(int runs, double most, const Run& run) {
    std::mt19937 random(1);
    outcome bad;
    for (int k = 0; k < runs; ++k) {
        std::uniform_real_distribution<double> u(0, 1);
        const double a = u(random), b = u(random);
        const auto [with, without] = run(a, b);
        bad.with += !(with <= most);
        bad.without += !(without <= most);
    }
    return bad;
}

const auto standard = sc::radau_iia<3>();

}  // namespace

BOOST_AUTO_TEST_CASE(jumps_one_jump_of_f_at_an_unknown_time) {
    const auto without = sc::without<sc::guards::jumps>(standard);
    const auto bad = count(100, 10, [&](double a, double b) {
        const double at = 1 + 8 * a, jump = 0.1 + 2 * b;
        const auto f = [=](double t, const VectorXd& y, VectorXd& dy) {
            dy.resize(2);
            dy << std::cos(t) + (t < at ? 0 : jump), -y[1];
        };
        const VectorXd exact = state({std::sin(10.0) + jump * (10 - at), std::exp(-10.0)});
        return std::pair(error_of(standard, f, state({0, 1}), 10, 1e-6, exact),
                         error_of(without, f, state({0, 1}), 10, 1e-6, exact));
    });
    BOOST_TEST(bad.with == 0);
    BOOST_TEST(bad.without > 10);
}

BOOST_AUTO_TEST_CASE(growth_an_ignition_from_far_below_the_tolerance) {
    const auto without = sc::without<sc::guards::growth>(standard);
    const auto bad = count(30, 100, [&](double a, double b) {
        const double rate = 0.5 + 3 * a, from = std::pow(10, -9 - 3 * b),
                     t1 = std::log((1 - from) / from) / rate;
        const auto f = [=](double, const VectorXd& y, VectorXd& dy) {
            dy.resize(1);
            dy[0] = rate * y[0] * (1 - y[0]);
        };
        const VectorXd exact = state({0.5});  // y / (1 - y) grows by e^{rate t}, to one
        return std::pair(error_of(standard, f, state({from}), t1, 1e-4, exact),
                         error_of(without, f, state({from}), t1, 1e-4, exact));
    });
    BOOST_TEST(bad.with == 0);
    BOOST_TEST(bad.without > 10);
}

// y' = L (y - cos t) from (L^2 cos t - L sin t)/(L^2 + 1), whose slope at the start is almost zero: the first step is a
// thousandth of the span, and longer, wherever cos t may be by then.
BOOST_AUTO_TEST_CASE(first_step_across_many_periods_of_a_smooth_solution) {
    const auto without = sc::without<sc::guards::first_step>(standard);
    int bad_with = 0, bad_without = 0;
    for (const double tol : {1e-3, 1e-6})
        for (const double lambda : {-1e2, -1e4, -1e6, -1e8}) {
            const double square = lambda * lambda, t1 = 100;
            const auto f = [=](double t, const VectorXd& y, VectorXd& dy) {
                dy.resize(1);
                dy[0] = lambda * (y[0] - std::cos(t));
            };
            const VectorXd start = state({square / (square + 1)}),
                           exact = state({(square * std::cos(t1) - lambda * std::sin(t1)) / (square + 1)});
            const auto passes_over = [&](const auto& method) {
                const auto r = sc::integrate(method, f, start, 0.0, t1, {.rtol = tol, .atol = tol});
                return r.report.steps <= 2 || !(std::abs(r.y[0] - exact[0]) < 10 * tol);
            };
            bad_with += passes_over(standard);
            bad_without += passes_over(without);
        }
    BOOST_TEST(bad_with == 0);
    BOOST_TEST(bad_without > 0);
}

BOOST_AUTO_TEST_CASE(phase_a_wave_that_a_stiff_component_follows) {
    const auto without = sc::without<sc::guards::phase>(standard);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(0, 1);
    int above_ten_with = 0, above_ten_without = 0;
    for (int k = 0; k < 600; ++k) {
        const double lambda = -std::pow(10, 2 + 5 * u(random)), a = std::pow(10, -1 + 2 * u(random)),
                     omega = std::pow(10, -1 + 3 * u(random)), phase = 6.3 * u(random),
                     tol = std::pow(10, -7 + 4 * u(random)), t1 = 1 + 9 * u(random);
        const auto g = [&](double t) { return 1 + a * std::sin(omega * t + phase); };
        const auto f = [&](double t, const VectorXd& y, VectorXd& dy) {
            dy.resize(1);
            dy[0] = lambda * (y[0] - g(t)) + a * omega * std::cos(omega * t + phase);
        };
        const auto largest = [&](const auto& method) {
            double most = 0;
            const auto r =
                sc::integrate(method, f, state({g(0)}), 0.0, t1, {.rtol = tol, .atol = tol},
                              [&](double t, const VectorXd& y) {
                                  most = std::max(most, std::abs(y[0] - g(t)) / (tol + tol * std::abs(g(t))));
                              });
            return r.ok() ? most : INFINITY;
        };
        above_ten_with += !(largest(standard) <= 10);
        above_ten_without += !(largest(without) <= 10);
    }
    BOOST_TEST_MESSAGE("above ten tolerances: " << above_ten_with << " with, " << above_ten_without
                                                << " without");
    BOOST_TEST(2 * above_ten_with < above_ten_without);
}
