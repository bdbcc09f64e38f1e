// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE amplifier
#include <Eigen/LU>
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

BOOST_AUTO_TEST_CASE(a_start_off_the_constraints_moves_to_them_with_the_voltages_over_the_capacitors_kept) {
    // At nodes 1 and 2, 4 and 5, 7 and 8 the algebraic equations f1 + f2 = 0, f4 + f5 = 0, f7 + f8 = 0 are violated. y1 - y2,
    // y4 - y5 and y7 - y8 cannot jump: both nodes of a capacitor move by the same amount, found here by Newton's iteration.
    using vector = Eigen::Matrix<double, 8, 1>;
    vector y0;
    y0 << 5, 3, 3, 6, 3, 3, 6, 1;
    equations::transistor_amplifier amplifier;
    const auto moved = [&](const Eigen::Vector3d& by) {
        vector y = y0;
        for (int k = 0; k < 3; ++k) y[3 * k] += by[k], y[3 * k + 1] += by[k];
        return y;
    };
    const auto violated = [&](const Eigen::Vector3d& by) {
        vector f;
        amplifier(0.0, moved(by), f);
        return Eigen::Vector3d(f[0] + f[1], f[3] + f[4], f[6] + f[7]);
    };
    Eigen::Vector3d by = Eigen::Vector3d::Zero();
    for (int k = 0; k < 200 && violated(by).norm() > 1e-16; ++k) {
        Eigen::Matrix3d slopes;
        for (int j = 0; j < 3; ++j) {
            const Eigen::Vector3d d = 1e-7 * Eigen::Vector3d::Unit(j);
            slopes.col(j) = (violated(by + d) - violated(by - d)) / 2e-7;
        }
        Eigen::Vector3d step = -slopes.partialPivLu().solve(violated(by));
        while (!(violated(by + step).norm() < violated(by).norm()) && step.norm() > 1e-13) step /= 2;
        by += step;
    }
    BOOST_TEST(violated(by).norm() < 1e-12);
    BOOST_TEST(violated(Eigen::Vector3d::Zero()).norm() > 1e-4);
    for (const double tol : {1e-4, 1e-6, 1e-8}) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const auto r = sc::integrate(sc::radau_iia<3>(), amplifier, y0, 0, 0.2, o);
        const auto right = sc::integrate(sc::radau_iia<3>(), amplifier, moved(by), 0, 0.2, o);
        BOOST_TEST_CONTEXT("tol = " << tol) {
            BOOST_TEST(r.ok());
            BOOST_TEST(right.ok());
            BOOST_TEST(problems::error(r.y, right.y, 1) < 20 * tol);
        }
    }
}
