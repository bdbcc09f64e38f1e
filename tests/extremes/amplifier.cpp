// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE amplifier
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/equations.hpp>
#include <problems/stored.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>

// The transistor amplifier, index 1 with a mass matrix of rank 5: exp(u / 0.026) overflows where a step
// reaches too far, and then only a Jacobian at a state of the solution leads back.

namespace sc = stagecraft;

namespace {

template <class Method>
void within(const Method& method) {
    const Eigen::VectorXd exact = problems::reference("transamp");
    Eigen::Matrix<double, 8, 1> y0;
    y0 << 0, 3, 3, 6, 3, 3, 6, 0;
    for (int digits = 2; digits <= 11; ++digits) {
        const double tol = std::pow(10.0, -digits);
        const auto r =
            sc::integrate(method, equations::transistor_amplifier{}, y0, 0, 0.2, {.rtol = tol, .atol = tol});
        BOOST_TEST_CONTEXT("tol = 1e-" << digits) {
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(problems::error(r.y, exact, 1) < 20 * tol);
        }
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_tolerance_is_met_with_three_five_and_a_variable_number_of_stages) {
    within(sc::radau_iia<3>());
    within(sc::radau_iia<5>());
    within(sc::radau_iia_variable());
}

BOOST_AUTO_TEST_CASE(inconsistent_initial_values_are_no_success) {
    // At node 1 the algebraic equation f1 + f2 = 0 is violated; no step, however small, mends that, as the
    // voltage over the capacitor, y1 - y2, cannot jump by what it takes.
    Eigen::Matrix<double, 8, 1> y0;
    y0 << 5, 3, 3, 6, 3, 3, 6, 1;
    const auto r = sc::integrate(sc::radau_iia<3>(), equations::transistor_amplifier{}, y0, 0, 0.2,
                                 {.rtol = 1e-6, .atol = 1e-6});
    BOOST_TEST(!r.ok());
    BOOST_TEST(r.t == 0);
    BOOST_TEST((r.y == y0));
}
