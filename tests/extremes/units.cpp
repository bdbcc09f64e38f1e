// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE units
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

template <class Method, class Vector>
void takes_the_same_steps(const Method& method, const Vector& start) {
    const auto rotation = [](double, const Vector& y, Vector& f) {
        f[0] = y[1];
        f[1] = -y[0];
    };
    const auto run = [&](double scale) {
        return sc::integrate(method, rotation, (start * scale).eval(), 0, 5,
                             {.rtol = 1e-6, .atol = 1e-6 * scale});
    };
    const auto one = run(1);
    BOOST_TEST(one.ok());
    for (const double scale : {std::ldexp(1.0, -900), std::ldexp(1.0, -600), std::ldexp(1.0, 600)}) {
        const auto r = run(scale);
        BOOST_TEST_CONTEXT("s = " << method.stages() << " scale = " << scale) {
            BOOST_TEST(sc::name(r.status) == "success");
            BOOST_TEST(std::abs(r.report.steps - one.report.steps) <= 1);
            BOOST_TEST(std::abs(r.y[0] / scale - std::cos(5.0)) < 1e-4);
        }
    }
}

}  // namespace

// The units of y are a matter of taste: with atol in the same units the steps are the same, also where
// squares of y and of its error underflow or overflow.
BOOST_AUTO_TEST_CASE(the_scale_of_y_makes_no_difference) {
    const Vector2d fixed(1, 0);
    const Eigen::VectorXd dynamic = fixed;
    takes_the_same_steps(sc::radau_iia<2>(), fixed);
    takes_the_same_steps(sc::radau_iia<3>(), fixed);
    takes_the_same_steps(sc::radau_iia<4>(), fixed);
    takes_the_same_steps(sc::radau_iia<4>(), dynamic);
    takes_the_same_steps(sc::gauss<2>(), fixed);
    takes_the_same_steps(sc::lobatto_iiic<3>(), fixed);
}
