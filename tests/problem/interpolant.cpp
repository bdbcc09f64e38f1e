// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE interpolant
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/problem/interpolant.hpp>
#include <stdexcept>
#include <vector>

#include "../message.hpp"

namespace sc = stagecraft;
using sc::interpolant;
using sc::interpolation;
using std::vector;
using number = Eigen::Matrix<double, 1, 1>;

namespace {

const vector<double> times{0, 1, 1.5, 3, 4, 7};
double cubic(double t) { return 1 - 2 * t + 0.5 * t * t - 0.25 * t * t * t; }
vector<double> values_of(double (*f)(double), const vector<double>& t) {
    vector<double> v;
    for (const double x : t) v.push_back(f(x));
    return v;
}

// x' = -k (x - u(t)) stays within 1/k of u: the largest distance at the output times, in tolerances, and the steps.
struct followed {
    double distance;
    long steps;
};
followed follow(const interpolant<double>& u, double k, double tol, const sc::break_times<double>& breaks,
                const vector<double>& at, bool continuous = false) {
    sc::output_times<number> out(at);
    const auto f = [&](double t, const number& x, number& y) { y[0] = -k * (x[0] - u(t)); };
    const auto r =
        sc::integrate(sc::radau_iia<3>(), f, number(u(at.front())), at.front(), at.back(),
                      {.rtol = tol, .atol = tol, .continuous = continuous, .break_points = breaks}, out);
    BOOST_TEST(r.ok());
    double worst = 0;
    for (int j = 0; j < out.filled(); ++j)
        worst = std::max(worst, (std::abs(out.y(j)[0] - u(out.time(j))) - 1.1 / k) / tol);
    return {worst, r.report.steps};
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_at_the_knots_and_between) {
    for (const auto kind :
         {interpolation::steps, interpolation::linear, interpolation::cubic, interpolation::pchip}) {
        const interpolant u(times, values_of(cubic, times), kind);
        for (const double t : times) BOOST_TEST(std::abs(u(t) - cubic(t)) < 1e-13);
        for (const double t : {6.9, 0.1, 3.5}) BOOST_TEST((interpolant(u)(t) == u(t)));  // in any order
    }
    const interpolant steps(times, {1, 2, 3, 4, 5, 6}, interpolation::steps);
    BOOST_TEST((steps(0.99) == 1 && steps(1) == 2 && steps(6.99) == 5 && steps(7) == 6));
    BOOST_TEST(interpolant({0.0, 2.0}, {1.0, 5.0}, interpolation::linear)(0.5) == 2);
    BOOST_TEST(interpolant({0.0, 2.0}, {1.0, 5.0}, interpolation::cubic)(0.5) == 2);
    BOOST_TEST(interpolant(Eigen::Vector2d(0, 2), Eigen::Vector2d(1, 5), interpolation::pchip)(0.5) == 2);
    const interpolant spline(times, values_of(cubic, times), interpolation::cubic);
    const auto square = [](double t) { return t * t; };
    const interpolant parabola({0.0, 1.0, 4.0}, {0.0, 1.0, 16.0}, interpolation::cubic);
    const interpolant curve(times, {0, 0, 1, 1.5, 1.5, 9}, interpolation::pchip);
    for (double t = 0; t <= 7; t += 0.125) {
        BOOST_TEST(std::abs(spline(t) - cubic(t)) < 1e-12);  // a cubic is its own spline
        if (t <= 4) BOOST_TEST(std::abs(parabola(t) - square(t)) < 1e-14);
        if (t >= 0.125) BOOST_TEST(curve(t) >= curve(t - 0.125));
    }
    BOOST_TEST((curve(0.5) == 0 && curve(3.5) == 1.5));
}

BOOST_AUTO_TEST_CASE(duals_have_the_slope) {
    sc::dual<double, 1> t;
    t.value() = 2;
    t.derivatives()[0] = 1;
    const auto linear = interpolant(times, values_of(cubic, times), interpolation::linear)(t);
    BOOST_TEST(std::abs(linear.derivatives()[0] - (cubic(3) - cubic(1.5)) / 1.5) < 1e-14);
    const auto spline = interpolant(times, values_of(cubic, times), interpolation::cubic)(t);
    BOOST_TEST(std::abs(spline.value() - cubic(2)) < 1e-12);
    BOOST_TEST(std::abs(spline.derivatives()[0] - (-2 + 2 - 0.75 * 4)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(beyond_the_table) {
    const interpolant u({0.0, 1.0, 2.0}, {0.0, 1.0, 4.0}, interpolation::linear);
    BOOST_TEST(
        message<std::out_of_range>([&] { u(2.5); }) ==
        "interpolant: t = 2.5 is not between 0 and 2; with `extrapolate` the first and the last piece go on");
    BOOST_TEST(message<std::out_of_range>([&] { u(std::nan("")); }) != "no exception");
    const interpolant v({0.0, 1.0, 2.0}, {0.0, 1.0, 4.0}, interpolation::linear, sc::extrapolate);
    BOOST_TEST((v(3) == 7 && v(-1) == -1));
    const interpolant w({0.0, 1.0}, {1.0, 2.0}, interpolation::steps, sc::extrapolate);
    BOOST_TEST((w(3) == 2 && w(-1) == 1));
    BOOST_TEST(message<std::out_of_range>([&] { v(std::nan("")); }) != "no exception");
}

BOOST_AUTO_TEST_CASE(bad_tables_are_named) {
    const auto refused = [](vector<double> t, vector<double> v) {
        return message([&] { interpolant(t, v, interpolation::linear); });
    };
    const double inf = std::numeric_limits<double>::infinity();
    BOOST_TEST(refused({0}, {1}) == "interpolant: times must be two at least");
    BOOST_TEST(refused({0, 2, 1}, {1, 2, 3}) == "interpolant: times must be strictly increasing");
    BOOST_TEST(refused({0, 1, 1}, {1, 2, 3}) == "interpolant: times must be strictly increasing");
    BOOST_TEST(refused({0, 1}, {1, 2, 3}) == "interpolant: values must be as many as times");
    BOOST_TEST(refused({0, inf}, {1, 2}) == "interpolant: times must be finite");
    BOOST_TEST(refused({0, 1}, {1, inf}) == "interpolant: values must be finite");
}

BOOST_AUTO_TEST_CASE(steps_end_where_a_kink_matters) {
    const interpolant bent({0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 1.0, 2.0, 4.0, 6.01}, interpolation::linear);
    BOOST_TEST((bent.break_points() == vector<double>{2, 3}));
    BOOST_TEST((bent.break_points(0.01) == vector<double>{2}));
    const interpolant steps({0.0, 1.0, 2.0, 3.0}, {1.0, 1.0, 2.0, 5.0}, interpolation::steps);
    BOOST_TEST((steps.break_points() == vector<double>{2, 3}));
    BOOST_TEST(interpolant(times, values_of(cubic, times), interpolation::cubic).break_points().empty());
    // A stiff follower of 600 kinks is within the tolerance everywhere; without break points it passes over them.
    vector<double> seconds, table, halves;
    unsigned s = 12345;
    for (int i = 0; i <= 600; ++i) {
        s = s * 1664525u + 1013904223u;
        seconds.push_back(i);
        table.push_back((s >> 8) / double(1 << 24));
        halves.push_back(i);
        if (i < 600) halves.push_back(i + 0.5);
    }
    const interpolant u(seconds, table, interpolation::linear);
    for (const double k : {1e3, 1e5, 1e7})
        for (const double tol : {1e-4, 1e-6})
            BOOST_TEST(follow(u, k, tol, u.break_points(tol), halves).distance < 10);
    BOOST_TEST(follow(u, 1e5, 1e-6, {}, halves).distance > 1e4);
    // (What a stiff component does between the ends of steps is seen with `continuous`.) Knots as close as those of a smooth function's table need none, at a tolerance that does not see them.
    vector<double> knots, smooth;
    for (int i = 0; i <= 100000; ++i) {
        knots.push_back(i * 1e-3);
        smooth.push_back(std::sin(knots.back()));
    }
    const interpolant v(knots, smooth, interpolation::linear);
    BOOST_TEST(v.break_points(1e-6).empty());
    BOOST_TEST(v.break_points().size() > 99000u);
    const auto seen = follow(v, 1e5, 1e-6, v.break_points(1e-6), {0, 10.3, 20.7, 55.5, 99.9, 100}, true);
    BOOST_TEST(seen.distance < 10);
    BOOST_TEST(seen.steps < 1500);
}
