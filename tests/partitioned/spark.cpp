// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE spark
// Holonomic systems by the pair of Lobatto IIIA and IIIB: constraints to rounding, order 2 s - 2, no drift in energy.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/coefficients/lobatto_iiib.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>
#include <stagecraft/spark.hpp>

#include "../message.hpp"
#include "../stepper/interrupt.hpp"

using namespace stagecraft;
using Eigen::Vector4d;

namespace {

// A bead on a curve r = 1 + cos(phi)/4 in polar coordinates, where M depends on the position, under gravity.
const auto bead = lagrangian<2, 1>(
    [](const auto& q, const auto& v) { return (v[0] * v[0] + q[0] * q[0] * v[1] * v[1]) / 2; },
    [](const auto& q) {
        using std::cos;
        return -q[0] * cos(q[1]);
    },
    [](const auto& q) {
        using std::cos;
        return q[0] - 1 - cos(q[1]) / 4;
    });

Vector4d start() {
    const double phi = 1, rate = 0.5;
    return {1 + std::cos(phi) / 4, phi, -std::sin(phi) * rate / 4, rate};
}
double energy(const Vector4d& y) {
    return total_energy<double>(bead, Eigen::Vector2d(y.head(2)), Eigen::Vector2d(y.tail(2)));
}

struct worst {
    double g = 0, gv = 0, first = 0, last = 0, end;
    void operator()(double t, const Vector4d& y) {
        const Eigen::Vector2d q = y.head(2), v = y.tail(2);
        g = std::max(g, std::abs(position_constraint<double>(bead, q, 0.0)[0]));
        gv = std::max(gv, constraint_violation(bead, q, v));
        const double off = std::abs(energy(y) - energy(start()));
        if (t < end / 10) first = std::max(first, off);
        if (t > end * 9 / 10) last = std::max(last, off);
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(steps_have_order_two_s_minus_two) {
    const Vector4d exact = integrate(gauss<5>(), index_reduced(bead), start(), 0, 1,
                                     {.rtol = 1e-14, .atol = 1e-14, .fixed_step = 0.01})
                               .y;
    const auto slope = [&](const auto& m, double h) {
        const auto error = [&](double step) {
            const auto r = integrate(m, index_reduced(bead), start(), 0, 1, {.fixed_step = step});
            BOOST_TEST(name(r.status) == "success");
            return (r.y - exact).norm();
        };
        return std::log2(error(h) / error(h / 2));
    };
    BOOST_TEST(std::abs(slope(spark(lobatto_iiia<2>(), lobatto_iiib<2>()), 0.01) - 2) < 0.05);
    BOOST_TEST(std::abs(slope(spark(lobatto_iiia<3>(), lobatto_iiib<3>()), 0.05) - 4) < 0.1);
    BOOST_TEST(std::abs(slope(spark(lobatto_iiia<4>(), lobatto_iiib<4>()), 0.1) - 6) < 0.3);
}

BOOST_AUTO_TEST_CASE(constraints_and_energy_are_kept_over_two_hundred_periods) {
    for (const double h : {0.05, 0.02}) {
        worst seen{.end = 1000};
        const auto r = integrate(spark(lobatto_iiia<2>(), lobatto_iiib<2>()), index_reduced(bead), start(), 0,
                                 seen.end, {.fixed_step = h}, seen);
        BOOST_TEST(name(r.status) == "success");
        BOOST_TEST(seen.g < 1e-13);
        BOOST_TEST(seen.gv < 1e-13);
        BOOST_TEST(seen.first < h * h);
        BOOST_TEST(seen.last < 1.01 * seen.first);
    }
}

BOOST_AUTO_TEST_CASE(a_run_that_is_cut_goes_on_with_the_same_bits) {
    interrupted::at_five_places(spark(lobatto_iiia<2>(), lobatto_iiib<2>()), index_reduced(bead), start(), 2,
                                {.fixed_step = 0.01});
}

BOOST_AUTO_TEST_CASE(what_spark_cannot_do_is_said) {
    BOOST_TEST(
        message([] { spark(gauss<2>(), gauss<2>()); }).starts_with("spark: the tableaux must have the form"));
    BOOST_TEST(message([] {
                   integrate(spark(lobatto_iiia<2>(), lobatto_iiib<2>()), index_reduced(bead), start(), 0, 1);
               }) == "integrate: spark has no error estimate: give options.fixed_step");
}
