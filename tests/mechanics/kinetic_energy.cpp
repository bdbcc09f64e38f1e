// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE kinetic_energy
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stdexcept>
#include <string>

using namespace stagecraft;

BOOST_AUTO_TEST_CASE(a_kinetic_energy_that_is_no_quadratic_polynomial_is_refused) {
    const auto height = [](const auto& q) { return q[1]; };
    const auto sphere = [](const auto& q) { return q.squaredNorm() - 1; };
    const auto start = [&](const auto& T) {
        const auto model = lagrangian<2, 1>(T, height, sphere);
        index_2(model).initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0.3));
    };
    const auto refused = [](const std::invalid_argument& e) {
        return std::string(e.what()).find("T(q, v) must be a quadratic polynomial in v") != std::string::npos;
    };
    start([](const auto& q, const auto& v) { return v.squaredNorm() * (1 + q[0] * q[0]) / 2 + v[1] + q[0]; });
    BOOST_CHECK_EXCEPTION(
        start([](const auto&, const auto& v) { return v.squaredNorm() / 2 + v[0] * v[0] * v[0]; }),
        std::invalid_argument, refused);
    BOOST_CHECK_EXCEPTION(start([](const auto&, const auto& v) {
                              using std::sqrt;  // of relativity
                              return 1 - sqrt(1 - v.squaredNorm() / 1e4);
                          }),
                          std::invalid_argument, refused);
}

// A bead on the unit circle has inertia about the centre only: M is singular along q. Any multiple of (q.v)^2, which
// vanishes along the motion, gives it back, and neither motion nor multiplier depends on which.
BOOST_AUTO_TEST_CASE(a_multiple_of_the_squared_constraint_makes_a_singular_mass_regular) {
    const auto run = [](double multiple) {
        const auto T = [multiple](const auto& q, const auto& v) {
            const auto turn = q[0] * v[1] - q[1] * v[0], along = q[0] * v[0] + q[1] * v[1];
            return (turn * turn + multiple * along * along) / 2;
        };
        const auto bead = index_2(lagrangian<2, 1>(
            T, [](const auto& q) { return q[1]; }, [](const auto& q) { return q.squaredNorm() - 1; }));
        const auto y0 = bead.initial_state(Eigen::Vector2d(0.6, 0.8), Eigen::Vector2d(-0.4, 0.3));
        return integrate(radau_iia<3>(), bead, y0, 0, 2, {.rtol = 1e-10, .atol = 1e-10}).y;
    };
    const auto y = run(1), other = run(10);
    BOOST_TEST((y - other).head(4).norm() < 1e-8);
    BOOST_TEST(std::abs(y[4] - other[4]) < 1e-6);
    BOOST_CHECK_EXCEPTION(run(0), std::domain_error, [](const std::domain_error& e) {
        return std::string(e.what()).find("add a multiple of (G v + b)^2 to T") != std::string::npos;
    });
}
