// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE bvp_singular_ends
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/gauss_variable.hpp>
#include <stagecraft/last_return.hpp>
#include <string>

// What is no layer, though the modes look fast: the neighbourhood of a regular singular point, turns, a phase that moves
// nothing, a condition in units of its own.

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

// The regular solution of y'' + k y'/t - k y/t^2 = y/e, 1 at t = 1: Bessel's I_1 (k = 1), the spherical i_1 (k = 2).
struct regular_solution {
    int k;
    double e;
    double operator()(double t) const { return shape(t / std::sqrt(e)) / shape(1 / std::sqrt(e)); }
    double shape(double x) const {
        if (k == 1) return std::cyl_bessel_i(1.0, x);
        return x < 0.01 ? x / 3 * (1 + x * x / 10) : std::cosh(x) / x - std::sinh(x) / (x * x);
    }
};

// With the singular point at 0, or mirrored at 1.
void check_singular_end(int k, double e, bool mirrored, double tolerance, int intervals) {
    const auto f = [=](const auto& t, const auto& y, auto& f) {
        const auto r = mirrored ? 1 - t : t;
        f[0] = y[1];
        f[1] = (mirrored ? k : -k) * y[1] / r + k * y[0] / (r * r) + y[0] / e;
    };
    const auto ends = [=](const auto& left, const auto& right, auto& r) {
        r[0] = left[0] - (mirrored ? 1 : 0);
        r[1] = right[0] - (mirrored ? 0 : 1);
    };
    const auto r = sc::solve_bvp(sc::gauss_variable(), sc::two_point(f, ends), 0.0, 1.0, Vector2d(0, 0),
                                 {.rtol = tolerance, .intervals = intervals});
    const regular_solution exact{k, e};
    BOOST_TEST_CONTEXT("k = " << k << " e = " << e << " mirrored " << mirrored << " rtol = " << tolerance
                              << " intervals = " << intervals << " -> " << r.report.intervals) {
        BOOST_TEST_REQUIRE(sc::name(r.status) == "success", r.message);
        double worst = 0;
        for (int i = 1; i <= 500; ++i) {
            const double t = i / 500.0;
            worst = std::max(worst, std::abs(r.y(mirrored ? 1 - t : t)[0] - exact(t)));
        }
        BOOST_TEST(worst < 2 * tolerance);
        BOOST_TEST(worst < 10 * r.error.global + 1e-13);
        BOOST_TEST(r.report.intervals <= std::max(200, 2 * intervals));
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_regular_singular_end_asks_for_no_fine_mesh_at_any_tolerance) {
    for (const int k : {1, 2})
        for (const double e : {1.0, 1e-2, 1e-4})
            for (const bool mirrored : {false, true})
                for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6, 1e-9})
                    for (const int intervals : {0, 40, 400})
                        check_singular_end(k, e, mirrored, tolerance, intervals);
}

// The negative half: a layer at the end is still resolved where only a mode has it.
BOOST_AUTO_TEST_CASE(a_layer_at_the_end_is_no_singular_point) {
    for (const double e : {1e-3, 1e-5, 1e-7}) {
        const auto f = [e](const auto&, const auto& y, auto& f) {
            f[0] = y[1];
            f[1] = -y[1] / e;
        };
        const auto ends = [](const auto& left, const auto& right, auto& r) {
            r[0] = left[0] - 1;
            r[1] = right[0] - 1;
        };
        const auto r = sc::solve_bvp(sc::gauss_variable(), sc::two_point(f, ends), 0.0, 1.0, Vector2d(0, 0));
        BOOST_TEST(sc::name(r.status) == "success", r.message);
        BOOST_TEST(std::abs(r.y(0.5)[0] - 1) < 1e-6);
        BOOST_TEST(r.conditioning.kappa1 * e > 0.9);  // of y' at 0
        BOOST_TEST(r.conditioning.kappa1 * e < 2);
    }
}

// y'' = -w^2 y, y(0) = 0, y(1) = 1: sin(w t)/sin(w).
BOOST_AUTO_TEST_CASE(many_turns_are_found_from_the_usual_mesh) {
    for (const double w : {100.0, 1000.0, 2000.0, 3000.0})
        for (const double tolerance : {1e-4, 1e-6}) {
            const auto f = [w](const auto&, const auto& y, auto& f) {
                f[0] = y[1];
                f[1] = -w * w * y[0];
            };
            const auto ends = [](const auto& left, const auto& right, auto& r) {
                r[0] = left[0];
                r[1] = right[0] - 1;
            };
            const auto r = sc::solve_bvp(sc::gauss_variable(), sc::two_point(f, ends), 0.0, 1.0,
                                         Vector2d(0, 0), {.rtol = tolerance});
            BOOST_TEST_CONTEXT("w = " << w << " rtol = " << tolerance << " intervals "
                                      << r.report.intervals) {
                BOOST_TEST(sc::name(r.status) == "success", r.message);
                double worst = 0;
                for (int i = 0; i <= 2000; ++i) {
                    const double exact = std::sin(w * (i / 2000.0)) / std::sin(w);
                    worst = std::max(worst, std::abs(r.y(i / 2000.0)[0] - exact) / (1 + std::abs(exact)));
                }
                BOOST_TEST(worst < 2 * tolerance);
                BOOST_TEST(r.report.intervals < 2 * w);
                BOOST_TEST(r.report.meshes <= 5);
            }
        }
}

// The units of a condition say nothing: Boltzmann's constant times a temperature.
BOOST_AUTO_TEST_CASE(a_condition_may_have_units_of_its_own) {
    const auto f = [](const auto&, const auto& y, auto& f) {
        f[0] = y[1];
        f[1] = y[0];
    };
    const auto check = [&](double unit, const auto& guess) {
        const auto ends = [unit](const auto& left, const auto& right, auto& r) {
            r[0] = unit * (left[0] - 300);
            r[1] = right[0] - 400;
        };
        const auto r = sc::solve_bvp(sc::gauss_variable(), sc::two_point(f, ends), 0.0, 1.0, guess);
        BOOST_TEST_CONTEXT("unit " << unit) {
            BOOST_TEST(sc::name(r.status) == "success", r.message);
            BOOST_TEST(std::abs(r.y(0.0)[0] - 300) < 1e-6);
            BOOST_TEST(r.kernel == 0);
        }
    };
    for (const double unit : {1e23, 1e14, 1.0, 1e-14, 1.38e-23}) {
        check(unit, Vector2d(300, 0));
        check(unit, VectorXd(Vector2d(300, 0)));
    }
}

// Where in its turn the guess begins does not matter: that the phase moves T by nothing is no doubt of the mesh.
BOOST_AUTO_TEST_CASE(a_relaxation_orbit_is_found_from_a_guess_of_any_phase) {
    const double eps = 1e-4;
    const auto f = [eps](const auto&, const auto& y, auto& f) {
        f[0] = y[0] - y[0] * y[0] * y[0] / 3 - y[1] + 0.5;
        f[1] = eps * (y[0] + 0.7 - 0.8 * y[1]);
    };
    for (const double span : {2.9, 3.0, 3.3, 3.6, 4.0, 4.5}) {
        const auto guess = sc::last_return(sc::radau_iia<3>(), f, Vector2d(1, 0), 0.0, span / eps);
        const auto orbit = sc::periodic_orbit(sc::gauss<5>(), f, guess, {.rtol = 1e-4});
        BOOST_TEST_CONTEXT("span " << span << ", " << orbit.report.intervals << " intervals") {
            BOOST_TEST(sc::name(orbit.status) == "success", orbit.message);
            BOOST_TEST(std::abs(orbit.period / 19680.36104 - 1) < 1e-8);
            BOOST_TEST(orbit.report.intervals < 2000);
        }
    }
}
