// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE reference_problems
#include <boost/test/unit_test.hpp>
#include <problems/equations.hpp>
#include <problems/stored.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

namespace sc = stagecraft;

// Errors at the end stay within `factor` times the tolerance, at every tolerance and number of stages given:
// a Newton iteration stopped too early shows here first (Robertson loses three digits).
template <int Stages, class Problem, class Vector>
void within(const Problem& problem, const Vector& y0, double t1, const std::string& name, double floor,
            double factor) {
    const Eigen::VectorXd ref = problems::reference(name);
    for (double tol : {1e-4, 1e-6, 1e-8, 1e-10}) {
        const auto r =
            sc::integrate(sc::radau_iia<Stages>(), problem, y0, 0, t1, {.rtol = tol, .atol = tol * floor});
        BOOST_TEST_CONTEXT(name << " s = " << Stages << " tol = " << tol) {
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(r.t == t1);
            BOOST_TEST(problems::error(r.y, ref, floor) < factor * tol);
        }
    }
}

BOOST_AUTO_TEST_CASE(van_der_pol_1e_6_is_solved_to_tolerance) {
    within<3>(equations::van_der_pol{}, Eigen::Vector2d(2, -0.66), 2, "vdpol", 1, 10);
    within<5>(equations::van_der_pol{}, Eigen::Vector2d(2, -0.66), 2, "vdpol", 1, 10);
}

BOOST_AUTO_TEST_CASE(robertson_to_1e11_is_solved_to_tolerance) {
    within<3>(equations::robertson{}, Eigen::Vector3d(1, 0, 0), 1e11, "rober", 1e-6, 10);
    within<5>(equations::robertson{}, Eigen::Vector3d(1, 0, 0), 1e11, "rober", 1e-6, 10);
}

BOOST_AUTO_TEST_CASE(orego_is_solved_to_tolerance) {
    within<3>(equations::oregonator{}, Eigen::Vector3d(1, 2, 3), 360, "orego", 1e-6, 100);
}

BOOST_AUTO_TEST_CASE(hires_is_solved_to_tolerance) {
    Eigen::Matrix<double, 8, 1> y0 = Eigen::Matrix<double, 8, 1>::Zero();
    y0[0] = 1;
    y0[7] = 0.0057;
    within<3>(equations::hires{}, y0, 321.8122, "hires", 1e-4, 100);
}

BOOST_AUTO_TEST_CASE(transistor_amplifier_of_index_1_with_singular_mass_is_solved_to_tolerance) {
    Eigen::Matrix<double, 8, 1> y0;
    y0 << 0, 3, 3, 6, 3, 3, 6, 0;
    within<3>(equations::transistor_amplifier{}, y0, 0.2, "transamp", 1, 30);
}

BOOST_AUTO_TEST_CASE(a_loose_tolerance_gives_a_larger_error_than_a_tight_one) {
    const Eigen::VectorXd ref = problems::reference("vdpol");
    const auto error = [&](double tol) {
        return problems::error(sc::integrate(sc::radau_iia<3>(), equations::van_der_pol{},
                                             Eigen::Vector2d(2, -0.66), 0, 2, {.rtol = tol, .atol = tol})
                                   .y,
                               ref, 1);
    };
    BOOST_TEST(error(1e-4) > 100 * error(1e-8));
}
