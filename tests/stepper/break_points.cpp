// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE break_points
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <sstream>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/save_every.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <stagecraft/sensitivity/adjoint.hpp>
#include <stagecraft/sensitivity/forward.hpp>
#include <stagecraft/steps.hpp>
#include <vector>

#include "../message.hpp"
#include "methods.hpp"

namespace sc = stagecraft;
using number = Eigen::Matrix<double, 1, 1>;
using sc::every;
using breaks = sc::break_times<double>;

namespace {

const auto radau = sc::radau_iia<3>();

// y' = -k y + R while a < t < b, from 0.
double answer(double t, double k, double R, double a, double b) {
    if (t <= a) return 0;
    const double e = std::min(t, b);
    return R / k * (1 - std::exp(-k * (e - a))) * std::exp(-k * (t - e));
}

struct schedule {
    bool (*on)(double);
    double k, R, y0, t1, right;
    breaks times;
};
std::vector<schedule> schedules() {
    double pauses = 0, infusions = 0;
    for (int i = 0; i < 20; ++i) pauses += answer(200, 0.055, 4.12, 10 * i, 10 * i + 9.7);
    for (int i = 0; i < 14; ++i) infusions += answer(335.5, 0.3, 1000, 24 * i, 24 * i + 0.1);
    return {{[](double t) { return std::fmod(t, 10) < 9.7; }, 0.055, 4.12, 0, 200, pauses,
             every(10.0, {0.0, 9.7})},
            {[](double t) { return std::fmod(t, 24) < 0.1; }, 0.3, 1000, 0, 335.5, infusions,
             every(24.0, {0.0, 0.1})},
            {[](double t) { return std::fmod(t, 24) >= 7 && std::fmod(t, 24) <= 8; }, 0, 10, 0, 50, 20,
             every(24.0, {7.0, 8.0})},
            {[](double t) { return (t >= 1 && t <= 1.5) || (t >= 2 && t <= 2.5); },
             0.1,
             3000,
             1,
             30,
             std::exp(-3.0) + answer(30, 0.1, 3000, 1, 1.5) + answer(30, 0.1, 3000, 2, 2.5),
             {1.0, 1.5, 2.0, 2.5}},
            {[](double t) { return t > 0.05 && t < 0.06; }, 0, 1e3, 1000, 0.1, 1010, {0.05, 0.06}},
            {[](double t) { return t > 1 && t < 1.05; }, 1, 20, 1, 2,
             std::exp(-2.0) + answer(2, 1, 20, 1, 1.05), std::vector<double>{1, 1.05}}};
}
template <class Method>
double off(const Method& method, const schedule& s, const sc::options<double>& o) {
    const auto f = [&](double t, const number& y, number& out) {
        out[0] = -s.k * y[0] + (s.on(t) ? s.R : 0);
    };
    const auto r = sc::integrate(method, f, number(s.y0), 0, s.t1, o);
    BOOST_TEST(r.ok());
    return std::abs(r.y[0] - s.right) / (o.atol + o.rtol * std::abs(s.right));
}

// y' = 1 before 1, 2 up to 2.5, 4 behind; the times at which it is asked.
struct stairs {
    std::vector<double>* asked;
    void operator()(double t, const number&, number& f) const {
        if (asked) asked->push_back(t);
        f[0] = t < 1 ? 1 : t < 2.5 ? 2 : 4;
    }
};
double height(double t) { return t < 1 ? t : t < 2.5 ? 2 * t - 1 : 4 * t - 6; }

// Generic, with a jump at 1: y' = -p y, then -2 p y + t.
struct switched {
    template <class T, class Y, class P, class F>
    void operator()(const T& t, const Y& y, const P& p, F& f) const {
        f[0] = t < 1 ? -p[0] * y[0] : -2 * p[0] * y[0] + t;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_switched_at_known_times_is_right_at_every_tolerance) {
    for (const double tol : {1e-4, 1e-6, 1e-9})
        for (const auto& s : schedules()) {
            BOOST_TEST(off(radau, s, {.rtol = tol, .atol = tol, .break_points = s.times}) < 1);
            BOOST_TEST(off(sc::radau_iia_variable(), s, {.rtol = tol, .atol = tol, .break_points = s.times}) <
                       1);
            BOOST_TEST(
                off(methods::dormand_prince(), s, {.rtol = tol, .atol = tol, .break_points = s.times}) < 10);
        }
    // Without them a run can know nothing of a pulse between its steps.
    const auto all = schedules();
    BOOST_TEST(off(radau, all[2], {.rtol = 1e-6, .atol = 1e-6}) > 1e5);
}

BOOST_AUTO_TEST_CASE(f_is_asked_on_its_own_side_alone_and_a_step_ends_there) {
    const auto check = [](const auto& method, sc::options<double> o, double t0, double t1) {
        std::vector<double> asked, ends;
        std::size_t seen = 0;
        o.break_points = {1.0, 2.5};
        const auto watch = [&](double t, const number& y) {
            const double before = ends.empty() ? t0 : ends.back();
            for (; seen < asked.size(); ++seen) {
                const double a = asked[seen];
                BOOST_TEST((t0 < t1 ? a >= before - 1e-15 && a <= t + 1e-15
                                    : a <= before + 1e-15 && a >= t - 1e-15));
                BOOST_TEST(
                    ((a < 1) == (std::max(t, before) <= 1) && (a < 2.5) == (std::max(t, before) <= 2.5)));
                BOOST_TEST((a != 1 && a != 2.5));
            }
            BOOST_TEST(std::abs(y[0] - height(t)) < 1e-13);
            ends.push_back(t);
        };
        const auto r = sc::integrate(method, stairs{&asked}, number(height(t0)), t0, t1, o, watch);
        BOOST_TEST(r.ok());
        BOOST_TEST(r.t == t1);
        for (const double b : {1.0, 2.5})
            BOOST_TEST(std::count(ends.begin(), ends.end(), b) == (b == t0 ? 0 : 1));
        BOOST_TEST(static_cast<long>(asked.size()) == r.report.f + r.report.f_jacobian);
        BOOST_TEST(r.report.rejected() == 0);
    };
    for (const auto& [t0, t1] :
         {std::pair(0.0, 4.0), std::pair(4.0, 0.0), std::pair(1.0, 2.5), std::pair(2.5, 1.0)}) {
        check(radau, {}, t0, t1);
        check(methods::dormand_prince(), {}, t0, t1);
        check(radau, {.fixed_step = 0.4}, t0, t1);
        check(sc::gauss<2>(), {.fixed_step = 0.4}, t0, t1);
        check(methods::classical(), {.fixed_step = 0.4}, t0, t1);
    }
}

BOOST_AUTO_TEST_CASE(equal_steps_divide_each_part) {
    std::vector<double> ends;
    const auto r = sc::integrate(radau, stairs{nullptr}, number(0.0), 0, 4,
                                 {.fixed_step = 0.6, .break_points = {1.0, 2.5}},
                                 [&](double t, const number&) { ends.push_back(t); });
    BOOST_TEST(r.report.steps == 2 + 3 + 3);
    const double expected[] = {0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4};
    BOOST_REQUIRE(ends.size() == 8u);
    for (std::size_t i = 0; i < 8; ++i) BOOST_TEST(std::abs(ends[i] - expected[i]) < 1e-14);
    BOOST_TEST((ends[1] == 1 && ends[4] == 2.5 && ends[7] == 4));
}

// Everything is as in runs that are joined by hand, to the bit, and as if they were one.
BOOST_AUTO_TEST_CASE(the_parts_are_runs_of_their_own) {
    const auto f = [](double t, const Eigen::Vector2d& y, Eigen::Vector2d& out) {
        out << y[1], 5 * (1 - y[0] * y[0]) * y[1] - y[0] + (t < 1 ? 0 : 3);
    };
    const Eigen::Vector2d y0(2, 0);
    const sc::options<double> o{.rtol = 1e-7, .atol = 1e-7};
    const double before = std::nextafter(1.0, 0.0), after = std::nextafter(1.0, 2.0);
    const auto first = sc::integrate(radau, f, y0, 0, before, o);
    const auto second = sc::integrate(radau, f, first.y, after, 3, o);
    sc::solution<Eigen::Vector2d> y;
    sc::output_times<Eigen::Vector2d> table({0, 0.5, 1, 2, 3});
    auto watch =
        sc::events<Eigen::Vector2d>(sc::event([](double t, const Eigen::Vector2d&) { return t - 1.5; }),
                                    sc::event([](double t, const Eigen::Vector2d&) { return t - 1; }));
    std::vector<sc::checkpoint<Eigen::Vector2d>> points;
    auto with = o;
    with.break_points = {1.0};
    const auto r = sc::integrate(
        radau, f, y0, 0, 3, with,
        sc::observers(watch, y, table, sc::save_every(1, [&](auto p) { points.push_back(p); })));
    BOOST_TEST((r.y == second.y));
    BOOST_TEST(r.report.steps == first.report.steps + second.report.steps);
    BOOST_TEST(r.report.f == first.report.f + second.report.f);
    BOOST_TEST(r.report.jacobians == first.report.jacobians + second.report.jacobians);
    BOOST_TEST((y(1) - first.y).norm() < 1e-14);
    BOOST_TEST((table.y(2) == first.y));
    BOOST_TEST(table.filled() == 5);
    BOOST_TEST((table.y(3) - y(2)).norm() < 1e-15);
    // An event at the break point is met once.
    BOOST_REQUIRE(watch.found().size() == 2u);
    BOOST_TEST((watch.found()[0].event == 1 && watch.found()[0].t == 1));
    BOOST_TEST(std::abs(watch.found()[1].t - 1.5) < 1e-15);
    // From any checkpoint, the one at the break point as well, written and read.
    BOOST_TEST(points.size() == static_cast<std::size_t>(r.report.steps));
    for (const auto& point : points) {
        std::stringstream text;
        text << point;
        sc::checkpoint<Eigen::Vector2d> read;
        text >> read;
        const auto rest = sc::integrate(radau, f, read, 3);
        BOOST_TEST((rest.y == r.y && rest.report.f == r.report.f && rest.report.steps == r.report.steps));
    }
    // As a loop.
    auto loop = sc::steps(radau, f, y0, 0, 3, with);
    long count = 0;
    for (const auto& step : loop) count += step.t == 1;
    BOOST_TEST((count == 1 && loop.y() == r.y));
}

BOOST_AUTO_TEST_CASE(a_problem_knows_its_own) {
    struct own : stairs {
        std::vector<double> break_points() const { return {-5, 1, 2.5, 100}; }  // of any interval
    };
    struct clock {
        auto break_points() const { return every(2, 1); }
        void operator()(double t, const number&, number& f) const { f[0] = std::fmod(t, 2) < 1 ? 0 : 1; }
    };
    const auto r = sc::integrate(radau, own{{nullptr}}, number(0.0), 0, 4);
    BOOST_TEST(std::abs(r.y[0] - height(4)) < 1e-13);
    BOOST_TEST(r.report.rejected() == 0);
    BOOST_TEST(r.report.found.has(sc::capability::break_points));
    // Together with those of the options.
    BOOST_TEST(
        std::abs(sc::integrate(radau, clock(), number(0.0), 0, 10, {.break_points = every(2, 2)}).y[0] - 5) <
        1e-13);
}

BOOST_AUTO_TEST_CASE(neighbouring_numbers_and_zero_are_break_points_too) {
    const double next = std::nextafter(1.0, 2.0);
    std::vector<double> ends;
    const auto r =
        sc::integrate(radau, stairs{nullptr}, number(-1.0), -1, 2, {.break_points = {0.0, 1.0, next}},
                      [&](double t, const number&) { ends.push_back(t); });
    BOOST_TEST(r.ok());
    for (const double b : {0.0, 1.0, next}) BOOST_TEST(std::count(ends.begin(), ends.end(), b) == 1);
    BOOST_TEST(std::abs(r.y[0] - 3) < 1e-13);
}

BOOST_AUTO_TEST_CASE(sensitivities_and_gradients_go_across) {
    const Eigen::Matrix<double, 1, 1> y0(2.0), p(0.7);
    const double e = std::exp(-0.7), at_1 = 2 * e, k = 1.4, E = std::exp(-k);
    // From 1: y = t/k - 1/k^2 + C exp(-k (t - 1)), C = y(1) - 1/k + 1/k^2.
    const double C = at_1 - 1 / k + 1 / (k * k), right = 2 / k - 1 / (k * k) + C * E;
    const double dC = -at_1 + 2 / (k * k) - 4 / (k * k * k);
    const double slope = -4 / (k * k) + 4 / (k * k * k) + dC * E - 2 * C * E;
    const sc::options<double> o{.rtol = 1e-9, .atol = 1e-9, .break_points = {1.0}};
    const auto s = sc::sensitivities(radau, switched(), y0, p, 0, 2, o);
    BOOST_TEST(std::abs(s.y[0] - right) < 1e-8);
    BOOST_TEST(std::abs(s.S(0, 0) - slope) < 1e-7);
    const auto g = sc::adjoint_gradient(
        radau, switched(), y0, p, 0, 2, [](const auto& y) { return y[0]; }, o);
    BOOST_TEST(std::abs(g.dp[0] - slope) < 1e-7);
    BOOST_TEST(std::abs(g.dy0[0] - e * E) < 1e-7);
}

BOOST_AUTO_TEST_CASE(bad_break_points_are_named) {
    const auto refused = [](const breaks& times) {
        return message(
            [&] { sc::integrate(radau, stairs{nullptr}, number(0.0), 0, 4, {.break_points = times}); });
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_TEST(refused({2.0, 1.0, 3.0}) == "integrate: break_points must be in order, each one once");
    BOOST_TEST(refused({1.0, 2.0, 2.0}) == "integrate: break_points must be in order, each one once");
    BOOST_TEST(refused({1.0, 1.0}) == "integrate: break_points must be in order, each one once");
    BOOST_TEST(refused({1.0, 5.0}) == "integrate: break_points must lie between t0 and t1");
    BOOST_TEST(refused({-1.0}) == "integrate: break_points must lie between t0 and t1");
    BOOST_TEST(refused({1.0, nan}) == "integrate: break_points must be finite");
    BOOST_TEST(refused(every(0.0)) ==
               "integrate: break_points: the period of every() must be positive and finite");
    BOOST_TEST(refused(every(1e-17)) == "integrate: break_points: t does not resolve the period of every()");
    BOOST_TEST(refused(every(1.0, {0.0, 2.0})) ==
               "integrate: break_points: the times of every() must lie within one period");
    BOOST_TEST(refused({3.0, 2.0, 1.0}) == "no exception");
    BOOST_TEST(refused({}) == "no exception");
    BOOST_TEST(refused({0.0, 4.0}) == "no exception");
    BOOST_TEST(message([] {
                   sc::steps(radau, stairs{nullptr}, number(0.0), 0, 4, {.break_points = {5.0}});
               }) == "steps: break_points must lie between t0 and t1");
}
