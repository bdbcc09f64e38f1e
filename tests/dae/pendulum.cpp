// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE pendulum
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

#include "problems.hpp"

namespace sc = stagecraft;
template <class S, int N>
using vec = Eigen::Matrix<S, N, 1>;

// The pendulum as index 1 (its acceleration constraint) and index 2 (its velocity constraint) against the
// equation of its angle.
BOOST_AUTO_TEST_CASE(the_pendulum_as_index_1_and_2_moves_like_its_angle) {
    const double t = 3;
    const vec<double, 4> exact = dae::pendulum_by_angle(t);
    vec<double, 5> start;
    start << 1, 0, 0, 0, 0;
    const sc::options<double> tol{.rtol = 1e-10, .atol = 1e-10};
    const auto first = sc::integrate(sc::radau_iia<5>(),
                                     sc::semi_explicit<4, 1>(dae::pendulum_f{}, dae::pendulum_acceleration{}),
                                     start, 0, t, tol);
    const auto second =
        sc::integrate(sc::radau_iia<5>(),
                      sc::semi_explicit<4, 1>(dae::pendulum_f{}, dae::pendulum_velocity{}), start, 0, t, tol);
    const auto third = sc::integrate(sc::radau_iia<5>(), dae::pendulum_3{}, start, 0, t, tol);
    BOOST_TEST((first.y.head<4>() - exact).norm() < 1e-8);
    BOOST_TEST((second.y.head<4>() - exact).norm() < 1e-8);
    BOOST_TEST((third.y.head<4>() - exact).norm() < 1e-7);
    // lambda = v.v - y for the unit length
    for (const auto* r : {&first, &second})
        BOOST_TEST(std::abs(r->y[4] - (exact.tail<2>().squaredNorm() - exact[1])) < 1e-6);
    // Another motion is not taken for this one.
    BOOST_TEST((first.y.head<4>() - dae::pendulum_by_angle(t + 1e-3)).norm() > 1e-4);
}
