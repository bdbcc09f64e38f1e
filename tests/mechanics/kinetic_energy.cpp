// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE kinetic_energy
#include <boost/test/unit_test.hpp>
#include <cmath>
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
