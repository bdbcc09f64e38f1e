// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE test_set
#include <boost/test/unit_test.hpp>
#include <problems/test_set/charge_pump.hpp>
#include <problems/test_set/fekete.hpp>
#include <problems/test_set/hard_case.hpp>
#include <problems/test_set/nand_gate.hpp>
#include <problems/test_set/slider_crank.hpp>
#include <problems/test_set/water_tubes.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

// Harder problems of the test set for initial value problems against the published values, behind one type.

using namespace problems::test_set;

namespace {

/// How far f is from 0 in the rows without a derivative.
double residual_at_start(const hard_case& c) {
    Eigen::VectorXd f(c.initial.size());
    c.problem(c.t0, c.initial, f);
    const Eigen::VectorXd rows = c.problem.mass().rowwise().lpNorm<1>();
    double largest = 0;
    for (Eigen::Index i = 0; i < f.size(); ++i)
        if (rows[i] == 0) largest = std::max(largest, std::abs(f[i]));
    return largest;
}

/// The error, in index 1, is below `tolerances` of them at 1e-4 and at 1e-8.
void follows_the_tolerance(const hard_case& c, double tolerances) {
    BOOST_TEST_CONTEXT(c.name) {
        BOOST_TEST(residual_at_start(c) < 1e-6);  // forces of 400 in the crank, published with ten digits
        for (const double tolerance : {1e-4, 1e-8}) {
            const auto r = stagecraft::integrate(stagecraft::radau_iia<3>(), c.problem, c.initial, c.t0, c.t1,
                                                 c.options(tolerance));
            BOOST_TEST(r.ok());
            BOOST_TEST(r.t == c.t1);
            BOOST_TEST(std::pow(10.0, -c.mescd(r.y)) < tolerances * tolerance);
        }
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(circuits_with_kinks_and_corners) {
    follows_the_tolerance(make_case(charge_pump()), 1);
    follows_the_tolerance(make_case(nand_gate()), 5);
}

BOOST_AUTO_TEST_CASE(tubes_that_turn_turbulent) { follows_the_tolerance(make_case(water_tubes()), 50); }

BOOST_AUTO_TEST_CASE(points_that_come_to_rest_on_a_sphere) { follows_the_tolerance(make_case(fekete()), 1); }

// Without damping what a step leaves stays, as a phase of the vibrations.
BOOST_AUTO_TEST_CASE(a_rod_that_vibrates) { follows_the_tolerance(make_case(slider_crank()), 1000); }
