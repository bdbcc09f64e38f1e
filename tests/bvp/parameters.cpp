// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_parameters
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <string>

namespace sc = stagecraft;
using Eigen::Vector2d;
using number = Eigen::Matrix<double, 1, 1>;

namespace {

// y' = -(p0 + w p1) y with y(0) = 1, y(1) = 1/2 and a third condition: c p0 - p1 = 0, or the sum of the others.
auto solve(double w, double c, bool sum, const Vector2d& p) {
    const auto f = [w](double, const number& y, const Vector2d& q, number& out) {
        out[0] = -(q[0] + w * q[1]) * y[0];
    };
    const auto r = [c, sum](const number& a, const number& b, const Vector2d& q, Eigen::Vector3d& out) {
        out << a[0] - 1, b[0] - 0.5, sum ? a[0] + b[0] - 1.5 : c * q[0] - q[1];
    };
    return sc::solve_bvp(sc::gauss<4>(), sc::two_point(f, r), 0.0, 1.0, number(1.0), p);
}

}  // namespace

BOOST_AUTO_TEST_CASE(parameters_are_found_where_the_conditions_fix_them) {
    const auto r = solve(1, 1, false, {0, 0});
    BOOST_TEST(sc::name(r.status) == "success");
    for (const double p : {r.p[0], r.p[1]}) BOOST_TEST(std::abs(p - std::log(2.0) / 2) < 1e-12);
}

// y is the same for all p0 + w p1 = log 2: only the parameters are not isolated.
BOOST_AUTO_TEST_CASE(parameters_that_nothing_fixes_are_not_isolated) {
    for (const Vector2d& p : {Vector2d(0, 0), Vector2d(5, 1)}) {
        const auto r = solve(1, 1, true, p);
        BOOST_TEST(sc::name(r.status) == "not_isolated");
        BOOST_TEST(r.kernel == 1);
        BOOST_TEST(r.message == "condition r[2] depends on those before it");
    }
    const auto absent = solve(0, 0, true, {1, 7});  // p1 stands nowhere
    BOOST_TEST(sc::name(absent.status) == "not_isolated");
    BOOST_TEST(absent.kernel == 1);
}

// dp1 = 1e11 times an error of y(1): what rounding makes of p1 is above the tolerance, whatever the mesh.
BOOST_AUTO_TEST_CASE(parameters_that_rounding_moves_are_ill_conditioned) {
    // Generic, as differences of f see nothing of 1e-11 p.
    const auto f = [](const auto&, const auto& y, const auto& q, auto& out) {
        out[0] = -(1 + 1e-11 * q[0]) * y[0];
    };
    const auto r = [](const number& a, const number& b, const number&, Vector2d& out) {
        out << a[0] - 1, b[0] - std::exp(-1.0);
    };
    const auto said = sc::solve_bvp(sc::gauss<4>(), sc::two_point(f, r), 0.0, 1.0, number(1.0), number(0.5));
    BOOST_TEST(sc::name(said.status) == "ill_conditioned");
}

// u'' + p u = 0, u(0) = u(1) = 0 with a normalisation that says nothing: u'(0)^2 = 0, or u(0) = 0 again. u = 0 for every p.
BOOST_AUTO_TEST_CASE(trivial_solutions_of_eigenvalue_problems_are_not_isolated) {
    const double pi = 3.14159265358979323846;
    const auto f = [](const auto&, const auto& y, const auto& p, auto& out) {
        out[0] = y[1];
        out[1] = -p[0] * y[0];
    };
    for (const double tolerance : {1e-4, 1e-7, 1e-10})
        for (const double size : {0.0, 0.01, 1.0})
            for (const double p : {5.0, 10.0, 30.0}) {
                const auto run = [&](int kind) {
                    const auto r = [kind](const auto& a, const auto& b, const auto&, auto& out) {
                        out[0] = a[0];
                        out[1] = b[0];
                        out[2] = kind == 0 ? a[0] : kind == 1 ? a[1] * a[1] : a[1] * a[1] - 1;
                    };
                    const auto guess = [&](double t) {
                        return Vector2d(size * std::sin(pi * t), size * pi * std::cos(pi * t));
                    };
                    return sc::solve_bvp(sc::gauss<5>(), sc::two_point(f, r), 0.0, 1.0, guess, number(p),
                                         {.rtol = tolerance});
                };
                BOOST_TEST(sc::name(run(0).status) == "not_isolated");
                BOOST_TEST(sc::name(run(1).status) == "not_isolated");
                const auto good = run(2);
                BOOST_TEST(sc::name(good.status) == (size > 0 ? "success" : "newton_failed"));
                if (good.ok()) BOOST_TEST(std::abs(good.p[0] - pi * pi) < 20 * tolerance);
            }
}
