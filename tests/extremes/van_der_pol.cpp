// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE van_der_pol
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/equations.hpp>
#include <problems/stored.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/tableaux/rounded.hpp>

// eps y'' = (1 - y^2) y' - y for eps = 1e-2 ... 1e-12.

namespace sc = stagecraft;
using enum sc::tableaux::family;

namespace {

auto solve(const sc::transformed_tableau<double>& m, double eps, double t1, double tol) {
    return sc::integrate(m, equations::van_der_pol{eps}, Eigen::Vector2d(2, -0.66), 0, t1,
                         {.rtol = tol, .atol = tol});
}

// On the slow manifold y' (1 - y^2) = y, so log y - y^2 / 2 = t + log 2 - 2 up to O(eps).
double slow(double t) {
    double y = 2;
    for (int k = 0; k < 50; ++k) y -= (std::log(y) - y * y / 2 - t - std::log(2.0) + 2) / (1 / y - y);
    return y;
}

}  // namespace

BOOST_AUTO_TEST_CASE(on_the_slow_manifold_the_solution_is_that_of_the_reduced_equation) {
    for (const int s : {2, 3, 5, 7}) {
        const auto m = sc::tableaux::transformed<double>(radau_iia, s);
        for (int k = 2; k <= 12; ++k) {
            const double eps = std::pow(10.0, -k), tol = 1e-8, y = slow(0.5);
            const auto r = solve(m, eps, 0.5, tol);
            BOOST_TEST_CONTEXT("s = " << s << " eps = 1e-" << k) {
                BOOST_TEST(sc::name(r.status) == "success");
                BOOST_TEST(std::abs(r.y[0] - y) < eps + 30 * tol);
                BOOST_TEST(std::abs(r.y[1] - y / (1 - y * y)) < 3 * eps + 30 * tol);
                if (k <= 4) BOOST_TEST(std::abs(r.y[0] - y) > eps / 100);  // the reduced equation is another
            }
        }
    }
}

// Through jumps of width eps: the reference at eps = 1e-6 has 15 digits; elsewhere two tolerances and two
// orders agree with each other.
BOOST_AUTO_TEST_CASE(through_the_jumps_every_eps_is_solved_to_tolerance) {
    const auto m3 = sc::tableaux::transformed<double>(radau_iia, 3);
    const auto m7 = sc::tableaux::transformed<double>(radau_iia, 7);
    for (const int k : {2, 3, 4, 6, 8, 10, 12}) {
        const double eps = std::pow(10.0, -k);
        const auto fine = solve(m7, eps, 2, 1e-11);
        BOOST_TEST_CONTEXT("eps = 1e-" << k) {
            BOOST_TEST(sc::name(fine.status) == "success");
            if (k == 6) BOOST_TEST(problems::error(fine.y, problems::reference("vdpol"), 1) < 1e-10);
            for (const double tol : {1e-4, 1e-6, 1e-8}) {
                const auto coarse = solve(m3, eps, 2, tol);
                BOOST_TEST(sc::name(coarse.status) == "success");
                BOOST_TEST(problems::error(coarse.y, fine.y, 1) < 20 * tol);
            }
        }
    }
}

// The cost is that of the slow parts and of the jumps, not of 1 / eps.
BOOST_AUTO_TEST_CASE(a_million_times_smaller_eps_costs_less_than_three_times_the_steps) {
    const auto m = sc::tableaux::transformed<double>(radau_iia, 5);
    const auto stiffer = solve(m, 1e-12, 2, 1e-6), stiff = solve(m, 1e-6, 2, 1e-6);
    BOOST_TEST(sc::name(stiffer.status) == "success");
    BOOST_TEST(sc::name(stiff.status) == "success");
    BOOST_TEST(stiffer.report.steps < 3 * stiff.report.steps);
}
