// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_jumps
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

// y'' = y + height H(t - d) with y(0) = 0, y(1) = 1.
struct switched {
    double d, height = 1;
    void operator()(double t, const Vector2d& y, Vector2d& f) const {
        f = Vector2d(y[1], y[0] + (t < d ? 0 : height));
    }
    void jacobian(double, const Vector2d&, Eigen::Matrix2d& J) const { J << 0, 1, 1, 0; }
    Vector2d exact(double t) const {
        const double A = (1 - height * (std::cosh(1 - d) - 1)) / std::sinh(1.0), later = std::max(0.0, t - d);
        return {A * std::sinh(t) + height * (std::cosh(later) - 1),
                A * std::cosh(t) + height * std::sinh(later)};
    }
};

template <class Method>
auto solve(const Method& method, const switched& f, const sc::bvp_options<double>& o) {
    const auto ends = [](const Vector2d& a, const Vector2d& b, Vector2d& r) { r = Vector2d(a[0], b[0] - 1); };
    return sc::solve_bvp(method, sc::two_point(f, ends), 0.0, 1.0, Vector2d(0, 1), o);
}

double error_of(const auto& y, const switched& f) {
    double worst = 0;
    for (int k = 0; k <= 4000; ++k) {
        const Vector2d exact = f.exact(k / 4000.0), e = y(k / 4000.0) - exact;
        worst = std::max(worst, (e.array().abs() / (1 + exact.array().abs())).maxCoeff());
    }
    return worst;
}

}  // namespace

// Meshes close in on the jump until no evaluation sees it: what is left between the last evaluation on one side of a mesh point
// and the first one on the other counts as error all the same.
BOOST_AUTO_TEST_CASE(a_jump_at_a_place_that_is_not_known_is_solved_to_the_tolerance) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> inside(0.02, 0.98);
    for (int k = 0; k < 60; ++k) {
        const switched f{inside(random)};
        for (const double tol : {1e-4, 1e-8}) BOOST_TEST_CONTEXT("jump at " << f.d << ", tolerance " << tol) {
                const auto r = solve(sc::gauss<4>(), f, {.rtol = tol});
                const double error = error_of(r.y, f);
                BOOST_TEST(r.ok());
                BOOST_TEST(error < 10 * tol);
                BOOST_TEST(error < 10 * r.error.global);
            }
    }
}

// Inside an interval the method and the rule that lifts it may miss the same part of a jump, the two Gauss points and the four
// that they are compared with do where it lies between 0.33 and 0.67. No mesh is finer everywhere for the sake of one jump.
BOOST_AUTO_TEST_CASE(a_jump_that_both_rules_miss_counts_as_error) {
    const auto check = [](const auto& method, double height) {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> inside(0.02, 0.98);
        int blind = 0, wrong = 0, failed = 0;
        long intervals = 0;
        for (int k = 0; k < 100; ++k) {
            const switched f{inside(random), height};
            const auto r = solve(method, f, {.rtol = 1e-6});
            const double error = error_of(r.y, f);
            failed += !r.ok(), blind += error > 10 * r.error.global, wrong += error > 4e-6;
            intervals += r.report.intervals;
        }
        BOOST_TEST(failed == 0);
        BOOST_TEST(blind == 0);
        BOOST_TEST(wrong == 0);
        return intervals / 100;
    };
    BOOST_TEST(check(sc::gauss<2>(), 100) < 600);
    BOOST_TEST(check(sc::gauss<3>(), 1) < 150);
    BOOST_TEST(check(sc::lobatto_iiia<5>(), 1) < 60);
}

// At points that the caller names nothing is doubted, and no mesh but the first is needed.
BOOST_AUTO_TEST_CASE(a_jump_at_a_fixed_point_costs_nothing) {
    for (const double d : {0.301, 0.5, 0.5001}) {
        const switched f{d};
        const auto r = solve(sc::gauss<4>(), f, {.rtol = 1e-10, .fixed_points = {d}});
        BOOST_TEST(r.ok());
        BOOST_TEST(error_of(r.y, f) < 1e-10);
        BOOST_TEST(r.report.intervals <= 11);
        BOOST_TEST(r.report.meshes == 1);
    }
}
