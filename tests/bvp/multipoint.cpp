// SPDX-License-Identifier: BSL-1.0
// Conditions inside, jumps, integrals and unknown ends, against closed forms; and plain guesses. All of one size of state, that
// is known at run time.
#define BOOST_TEST_MODULE bvp_multipoint
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stdexcept>
#include <string>

namespace sc = stagecraft;
using Eigen::VectorXd;
using parameter = Eigen::Matrix<double, 1, 1>;

namespace {

constexpr double pi = 3.14159265358979323846;

// y'' = -y; the state has its type at run time.
const auto wave = [](const auto&, const auto& y, auto& f) {
    f[0] = y[1];
    f[1] = -y[0];
};
const auto value = [](double at) { return [at](const auto& y) { return y[0] - at; }; };
VectorXd zero(int n) { return VectorXd::Zero(n); }

template <class Problem, class... More>
auto solve(const Problem& problem, double a, double b, const VectorXd& guess, const More&... more) {
    return sc::solve_bvp(sc::gauss<5>(), problem, a, b, guess, more...);
}

template <class Result>
void agrees(const Result& r, const auto& right, double tolerance) {
    BOOST_TEST(sc::name(r.status) == std::string("success"));
    BOOST_TEST(r.message.empty());
    for (int k = 0; k <= 50; ++k) {
        const double t = r.y.t0() + (r.y.t1() - r.y.t0()) * k / 50;
        BOOST_TEST((r.y(t) - right(t)).cwiseAbs().maxCoeff() <=
                   tolerance * (1 + right(t).cwiseAbs().maxCoeff()));
    }
}

template <class F>
void names(const std::string& what, F&& f) {
    BOOST_CHECK_EXCEPTION(f(), std::invalid_argument, [&](const std::invalid_argument& e) {
        return std::string(e.what()).find(what) != std::string::npos;
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_conditions_inside_fix_what_others_fix_at_the_ends) {
    // y(0.3) = 7, y(0.6) = 3.5 (BoundaryValueDiffEq.jl #268), nothing at the ends: A sin t + B cos t.
    const double d = std::sin(0.3), A = (7 * std::cos(0.6) - 3.5 * std::cos(0.3)) / -d,
                 B = (7 * std::sin(0.6) - 3.5 * std::sin(0.3)) / d;
    const auto right = [&](double t) -> VectorXd {
        return Eigen::Vector2d(A * std::sin(t) + B * std::cos(t), A * std::cos(t) - B * std::sin(t));
    };
    const auto none = [](const auto&, const auto&, auto&) {};
    const auto problem =
        sc::two_point(wave, none, sc::interior(0.6, value(3.5)), sc::interior(0.3, value(7)));
    for (const double rtol : {1e-4, 1e-10})
        agrees(solve(problem, 0, 1, zero(2), sc::bvp_options<double>{.rtol = rtol}), right, rtol);
    const auto r = solve(problem, 0, 1, zero(2));
    BOOST_TEST(std::abs(r.y(0.3)[0] - 7) < 1e-12);
    BOOST_TEST(r.mesh.front() == 0);
    BOOST_TEST(r.mesh.back() == 1);
    for (const double t : {0.3, 0.6}) BOOST_TEST(std::count(r.mesh.begin(), r.mesh.end(), t) == 1);
    // Five points, one of which is the only one that is not an end.
    const auto five = sc::two_point(
        [](const auto& t, const auto& y, auto& f) {
            for (int k = 0; k < 4; ++k) f[k] = y[k + 1];
            f[4] = 120. + 0. * t * y[0];
        },
        none, sc::interior(0.1, value(0)), sc::interior(0.3, value(0)), sc::interior(0.5, value(0)),
        sc::interior(0.7, value(0)), sc::interior(0.9, value(0)));
    const auto q = solve(five, 0, 1, zero(5), sc::bvp_options<double>{.rtol = 1e-8});
    BOOST_TEST(q.ok());
    for (const double t : {0.0, 0.2, 0.45, 1.0})
        BOOST_TEST(std::abs(q.y(t)[0] - (t - 0.1) * (t - 0.3) * (t - 0.5) * (t - 0.7) * (t - 0.9)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(y_jumps_where_a_relation_says_so) {
    const double A = (1 - 2 * std::cos(0.6)) / std::sin(1.);
    const auto right = [&](double t) -> VectorXd {
        const double more = t < 0.4 ? 0 : 2;
        return Eigen::Vector2d(A * std::sin(t) + more * std::cos(t - 0.4),
                               A * std::cos(t) - more * std::sin(t - 0.4));
    };
    const auto ends = [](const auto& l, const auto& r, auto& out) { out[0] = l[0], out[1] = r[0] - 1; };
    const auto kick = [](const auto& before, const auto& after, auto& out) {
        out[0] = after[0] - before[0] - 2, out[1] = after[1] - before[1];
    };
    const auto r = solve(sc::two_point(wave, ends, sc::jump_at(0.4, kick)), 0, 1, zero(2),
                         sc::bvp_options<double>{.rtol = 1e-10});
    agrees(r, right, 1e-10);
    BOOST_TEST(std::abs(r.y(0.4)[0] - r.y.before(0.4)[0] - 2) < 1e-12);
    // Chebfun's example: two materials, k y' continuous. k = 1 and 100, y(0) = 0, y(1) = 1, interface 1/3.
    const auto heat = [](const auto& t, const auto& y, auto& f) {
        f[0] = y[1] / (t < 1. / 3 ? 1. : 100.), f[1] = 0. * y[1];
    };
    const auto still = [](const auto& b, const auto& a, auto& out) {
        out[0] = a[0] - b[0], out[1] = a[1] - b[1];
    };
    const double flux = 1 / (1. / 3 + 2. / 300);
    agrees(
        solve(sc::two_point(heat, ends, sc::jump_at(1. / 3, still)), 0, 1, zero(2)),
        [&](double t) -> VectorXd {
            return Eigen::Vector2d(flux * (t < 1. / 3 ? t : 1. / 3 + (t - 1. / 3) / 100), flux);
        },
        1e-12);
}

BOOST_AUTO_TEST_CASE(an_integral_is_a_condition_for_a_parameter) {
    const auto load = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = y[1], f[1] = p[0] + 0. * y[0];
    };
    const auto ends = [](const auto& l, const auto& r, const auto&, auto& out) {
        out[0] = l[0], out[1] = r[0];
    };
    const auto area = [](const auto&, const auto& y) { return y[0]; };
    const auto r = solve(sc::two_point(load, ends, sc::integral(area, 1)), 0, 1, zero(2), parameter(1.0));
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(r.p[0] + 12) < 1e-10);
    BOOST_TEST(std::abs(r.y(0.5)[0] - 1.5) < 1e-10);
    // The first eigenfunction of y'' = -p y of norm 1 (AUTO's user conditions): p = pi^2, y = sqrt 2 sin(pi t).
    const auto mode = [](const auto&, const auto& y, const auto& p, auto& f) {
        f[0] = y[1], f[1] = -p[0] * y[0];
    };
    const auto square = [](const auto&, const auto& y) { return y[0] * y[0]; };
    const auto guess = [](double t) -> VectorXd { return Eigen::Vector2d(t * (1 - t) * 4, 4 - 8 * t); };
    const auto s = sc::solve_bvp(sc::gauss<5>(), sc::two_point(mode, ends, sc::integral(square, 1)), 0.0, 1.0,
                                 guess, parameter(8.0), {.rtol = 1e-9});
    BOOST_TEST(s.ok());
    BOOST_TEST(std::abs(s.p[0] - pi * pi) < 1e-8 * pi * pi);
    BOOST_TEST(std::abs(s.y(0.5)[0] - std::sqrt(2.)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(an_end_that_is_not_known_is_found) {
    // y'' = -y from (0, 1) until y = 0 again, at pi.
    const auto ends = [](const auto& l, const auto& r, auto& out) {
        out[0] = l[0], out[1] = l[1] - 1, out[2] = r[0];
    };
    const auto guess = [](double t) -> VectorXd { return Eigen::Vector2d(std::sin(t), std::cos(t)); };
    const auto r = sc::solve_bvp(sc::gauss<5>(), sc::two_point(wave, ends, sc::free_length()), 0.0, 2.8,
                                 guess, {.rtol = 1e-10});
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(r.y.t1() - pi) < 1e-9);
    BOOST_TEST(std::abs(r.y(1)[0] - std::sin(1.)) < 1e-9);
    BOOST_TEST(r.mesh.back() == r.y.t1());
    // Beside a condition inside: y(1) = sin 1 instead of y'(0) = 1.
    const auto fewer = [](const auto& l, const auto& r, auto& out) { out[0] = l[0], out[1] = r[0]; };
    const auto q = sc::solve_bvp(
        sc::gauss<5>(), sc::two_point(wave, fewer, sc::interior(1, value(std::sin(1.))), sc::free_length()),
        0.0, 2.8, guess, {.rtol = 1e-10});
    BOOST_TEST(q.ok());
    BOOST_TEST(std::abs(q.y.t1() - pi) < 1e-9);
    // A length that is negative is none.
    const auto back = [](const auto& l, const auto& r, auto& out) {
        out[0] = l[0], out[1] = l[1] - 1, out[2] = r[0] + 0.1;
    };
    const auto s =
        sc::solve_bvp(sc::gauss<5>(), sc::two_point(wave, back, sc::free_length()), 0.0, 0.01, guess);
    BOOST_TEST((!s.ok() || s.y.t1() > 0));
}

BOOST_AUTO_TEST_CASE(what_is_said_wrong_is_named) {
    const auto none = [](const auto&, const auto&, auto&) {};
    const auto one = [](const auto& l, const auto&, auto& out) { out[0] = l[0]; };
    const auto both = [](const auto& l, const auto& r, auto& out) { out[0] = l[0], out[1] = r[0]; };
    const auto at = [&](double t) { return sc::interior(t, value(1)); };
    names("inside (a, b)", [&] { solve(sc::two_point(wave, one, at(1)), 0, 1, zero(2)); });
    names("inside (a, b)", [&] { solve(sc::two_point(wave, one, at(std::nan(""))), 0, 1, zero(2)); });
    names("must write 1 numbers, not more",
          [&] { solve(sc::two_point(wave, both, at(0.5)), 0, 1, zero(2)); });
    names("more interior() and integral()",
          [&] { solve(sc::two_point(wave, none, at(.2), at(.3), at(.4)), 0, 1, zero(2)); });
    const auto still = [](const auto& b, const auto& a, auto& out) {
        out[0] = a[0] - b[0], out[1] = a[1] - b[1];
    };
    names("no more than one jump_at()", [&] {
        solve(sc::two_point(wave, both, sc::jump_at(.5, still), sc::jump_at(.5, still)), 0, 1, zero(2));
    });
    const auto hole = [](const auto& t, const auto& y, auto& f) {
        f[0] = y[1], f[1] = t > 0.7 ? std::numeric_limits<double>::quiet_NaN() * y[0] : -y[0];
    };
    const auto r = solve(sc::two_point(hole, one, at(0.5)), 0, 1, zero(2));
    BOOST_TEST(sc::name(r.status) == std::string("non_finite"));
    BOOST_TEST(r.message.find("at t = 0.7") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(max_intervals_are_those_of_all_pieces_together) {
    const auto f = [](const auto&, const auto& y, auto& d) { d[0] = y[1], d[1] = 100 * y[0]; };
    const auto ends = [](const auto& a, const auto&, auto& r) { r[0] = a[0] - 1; };
    const auto middle = [](const auto& y) { return y[0] - 1; };
    const auto r = solve(sc::two_point(f, ends, sc::interior(0.5, middle)), 0, 1, zero(2),
                         sc::bvp_options<double>{.rtol = 1e-13, .max_intervals = 12});
    BOOST_TEST(r.status == sc::bvp_status::too_many_intervals);
    BOOST_TEST(r.report.intervals <= 12);
}
