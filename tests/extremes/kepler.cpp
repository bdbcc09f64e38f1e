// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE kepler
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

// The Kepler problem with eccentricity 0.6 by equal steps: Gauss methods are symplectic and symmetric.

namespace sc = stagecraft;
using V4 = Eigen::Vector4d;

namespace {

struct kepler {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 4, 1>& y, Eigen::Matrix<S, 4, 1>& f) const {
        using std::sqrt;
        const S square = y[0] * y[0] + y[1] * y[1];
        const S g = 1.0 / (square * sqrt(square));
        f[0] = y[2];
        f[1] = y[3];
        f[2] = -g * y[0];
        f[3] = -g * y[1];
    }
};

const V4 perihelion(0.4, 0, 0, 2);
double energy(const V4& y) { return (y[2] * y[2] + y[3] * y[3]) / 2 - 1 / std::hypot(y[0], y[1]); }
double momentum(const V4& y) { return y[0] * y[3] - y[1] * y[2]; }

struct drift {
    double first_half = 0, second_half = 0, momentum = 0;
    V4 end;
};

/// Largest deviation of energy over the first and the second half of the run, and of angular momentum.
template <class Method>
drift run(const Method& method, long steps, double h) {
    drift d;
    long k = 0;
    const auto look = [&](double, const V4& y) {
        double& worst = 2 * ++k <= steps ? d.first_half : d.second_half;
        worst = std::max(worst, std::abs(energy(y) - energy(perihelion)));
        d.momentum = std::max(d.momentum, std::abs(momentum(y) - momentum(perihelion)));
    };
    const auto r = sc::integrate(method, kepler{}, perihelion, 0, static_cast<double>(steps) * h,
                                 {.rtol = 1e-14, .atol = 1e-14, .fixed_step = h}, look);
    BOOST_TEST(sc::name(r.status) == "success");
    BOOST_TEST(r.report.steps == steps);
    d.end = r.y;
    return d;
}

}  // namespace

BOOST_AUTO_TEST_CASE(gauss_keeps_the_energy_over_1e5_steps_and_radau_iia_does_not) {
    const drift three = run(sc::gauss<3>(), 100000, 0.05);
    BOOST_TEST_MESSAGE("gauss 3: " << three.first_half << " " << three.second_half << " " << three.momentum);
    BOOST_TEST(three.first_half < 1e-7);
    BOOST_TEST(three.second_half < 1.1 * three.first_half);  // it oscillates and does not grow
    const drift dissipative = run(sc::radau_iia<3>(), 20000, 0.05);
    BOOST_TEST_MESSAGE("radau: " << dissipative.first_half << " " << dissipative.second_half);
    BOOST_TEST(dissipative.second_half > 1.5 * dissipative.first_half);
}

// Angular momentum is quadratic, so Gauss keeps it exactly; rounding adds up as a random walk would.
BOOST_AUTO_TEST_CASE(gauss_keeps_angular_momentum_to_rounding_over_1e5_steps) {
    const double eps = std::numeric_limits<double>::epsilon();
    const drift two = run(sc::gauss<2>(), 100000, 0.01), five = run(sc::gauss<5>(), 100000, 0.05);
    BOOST_TEST_MESSAGE("momentum " << two.momentum / eps << " " << five.momentum / eps);
    BOOST_TEST(two.momentum < 2000 * eps);
    BOOST_TEST(five.momentum < 2000 * eps);
    BOOST_TEST(run(sc::radau_iia<3>(), 1000, 0.05).momentum > 1e6 * eps);
}

BOOST_AUTO_TEST_CASE(gauss_retraces_its_steps_in_reversed_time) {
    const auto there_and_back = [](const auto& method) {
        const sc::options<double> o{.rtol = 1e-14, .atol = 1e-14, .fixed_step = 0.05};
        const auto there = sc::integrate(method, kepler{}, perihelion, 0, 50, o);
        const auto back = sc::integrate(method, kepler{}, there.y, 50, 0, o);
        BOOST_TEST(back.ok());
        return (back.y - perihelion).norm();
    };
    BOOST_TEST(there_and_back(sc::gauss<3>()) < 1e-9);
    BOOST_TEST(there_and_back(sc::gauss<4>()) < 1e-9);
    BOOST_TEST(there_and_back(sc::radau_iia<3>()) > 1e-5);
}
