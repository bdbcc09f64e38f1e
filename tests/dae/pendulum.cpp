// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE pendulum
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>
#include <stagecraft/radau_iia_variable.hpp>

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

namespace {

// A bob on a rod of this length in metres, in seconds and with g = 9.81: the natural time is far from one.
struct in_metres {
    double length;
    static constexpr double g = 9.81;
    double time() const { return std::sqrt(length / g); }
    template <class S>
    void operator()(const S&, const vec<S, 5>& y, vec<S, 5>& f) const {
        f[0] = y[2];
        f[1] = y[3];
        f[2] = -y[4] * y[0];
        f[3] = -y[4] * y[1] - g;
        f[4] = y[0] * y[2] + y[1] * y[3];
    }
    Eigen::DiagonalMatrix<double, 5> mass() const { return dae::pendulum_3{}.mass(); }
    std::array<int, 5> index() const { return {1, 1, 1, 1, 2}; }
};

}  // namespace

// What the iteration leaves in the constraint takes |h| e of the multiplier to mend, whatever h is: no smaller step is
// asked for because of it, also where something else is in doubt.
BOOST_AUTO_TEST_CASE(rods_of_any_length_swing_to_the_end) {
    const double y = dae::pendulum_by_angle(2)[1];  // of length 1, g = 1
    const auto swings = [&](const auto& method, double length, double tol) {
        const in_metres p{length};
        sc::options<double> o{.rtol = tol};
        o.atol_components.resize(5);
        o.atol_components << length, length, length / p.time(), length / p.time(), 1 / (p.time() * p.time());
        o.atol_components *= tol;
        const vec<double, 5> start = length * vec<double, 5>::Unit(0);
        const auto r = sc::integrate(method, p, start, 0, 2 * p.time(), o);
        BOOST_TEST_CONTEXT("length " << length << ", tolerance " << tol) {
            BOOST_TEST(r.ok());
            BOOST_TEST(std::abs(r.y[1] / length - y) < 20 * tol);
            // |v|^2 = -2 g y. The control holds |h| times the error of the multiplier, h in seconds.
            BOOST_TEST(std::abs(r.y[4] * length / p.g + 3 * y) < 1e3 * tol * std::max(1., 1 / p.time()));
        }
    };
    for (const double length : {1e-6, 1e-3, 1., 30., 1e3, 1e4})
        for (const double tol : {1e-6, 1e-8, 1e-10, 1e-12}) {
            swings(sc::radau_iia<5>(), length, tol);
            swings(sc::radau_iia_variable(), length, tol);
        }
}
