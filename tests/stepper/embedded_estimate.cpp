// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE embedded_estimate
#include "methods.hpp"
#include "smooth.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/integrate.hpp>
#include <stagecraft/method/embedded_estimate.hpp>
#include <stagecraft/method/step_doubling.hpp>
#include <stdexcept>
#include <string>

namespace sc = stagecraft;
using method = sc::tableau<double>;
using V1 = Eigen::Matrix<double, 1, 1>;
using row = Eigen::VectorXd;

namespace {

// A-stable, y1 no stage (Norsett, Thomsen 1984).
method norsett_thomsen() {
    return methods::rows<double>({{5. / 6},
                                  {-61. / 108, 5. / 6},
                                  {-23. / 183, -33. / 61, 5. / 6},
                                  {25. / 61, 36. / 61},
                                  {26. / 61, 324. / 671, 1. / 11}},
                                 true);
}
// ARKODE's SDIRK-2-1.
method sdirk_2_1() { return methods::rows<double>({{1}, {-1, 1}, {0.5, 0.5}, {1}}, true); }
method midpoint() {
    method m = methods::rows<double>({{0.5}, {1}});
    m.facts.order = 2;
    return sc::step_doubling(m);
}
// SDIRK of order 3 with g = (3 + sqrt 3)/6 (Crouzeix 1975).
method crouzeix() {
    const double g = (3 + std::sqrt(3.)) / 6;
    return sc::step_doubling(methods::rows<double>({{g}, {1 - 2 * g, g}, {0.5, 0.5}}));
}
// Two stiffly accurate methods: half steps of Alexander's SDIRK of order 2 and a whole one.
method alexander() {
    const double g = 1 - std::sqrt(2.) / 2;
    return sc::step_doubling(methods::rows<double>({{g}, {1 - g, g}, {1 - g, g}}));
}
bool filtered(const method& m) {
    Eigen::VectorXd carry;
    const auto is = sc::structure_of(m, carry);
    return sc::needs_filter(m, is, row(m.b - m.b_embedded));
}

// The error at t = 10 in units of the tolerance; 0 where the run says that it could not meet it.
double error(const method& m, double lambda, double tol) {
    const auto r = sc::integrate(m, smooth::prothero_robinson{lambda}, V1(1.0), 0, 10,
                                 {.rtol = tol, .atol = tol, .max_steps = 20000});
    return r.ok() ? std::abs(r.y[0] - std::cos(10.0)) / tol : 0;
}

// Sayfy and Aburub's 4(3): weights at the nodes 0, 1/2 and 1 are those of Simpson's rule in both methods.
method sayfy_aburub() {
    return methods::rows<double>({{},
                                  {1. / 2},
                                  {-1, 2},
                                  {1. / 6, 2. / 3, 1. / 6},
                                  {0.137, 0.226, 0.137},
                                  {0.452, -0.904, -0.548, 0, 2},
                                  {1. / 6, 1. / 3, 1. / 12, 0, 1. / 3, 1. / 12},
                                  {1. / 6, 2. / 3, 1. / 6}},
                                 true);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_error_of_stiff_components_is_not_hidden_by_the_filter) {
    for (const auto& m : {norsett_thomsen(), sdirk_2_1(), midpoint(), crouzeix(), alexander()})
        for (const double lambda : {-1e2, -1e4, -1e6, -1e10})
            for (const double tol : {1e-3, 1e-6})
                for (int k = 0; k < 5; ++k)  // an accident would not repeat itself
                    BOOST_TEST(error(m, lambda * (1 + 1e-6 * k), tol) < 60);
    // ... and success is within reach
    BOOST_TEST(error(sdirk_2_1(), -1e6, 1e-4) > 0);
    BOOST_TEST(error(alexander(), -1e6, 1e-6) > 0);
}

BOOST_AUTO_TEST_CASE(an_estimate_is_filtered_where_it_does_not_decay_with_the_error) {
    BOOST_TEST(filtered(methods::sdirk_4_3()));
    BOOST_TEST(filtered(methods::tr_bdf2()));
    // y1 is no stage: its error is as large as the estimate
    BOOST_TEST(!filtered(norsett_thomsen()));
    BOOST_TEST(!filtered(sdirk_2_1()));
    BOOST_TEST(!filtered(midpoint()));
    // both methods are stiffly accurate: the estimate decays by itself
    BOOST_TEST(!filtered(alexander()));
    BOOST_TEST(!filtered(
        sc::step_doubling(methods::rows<double>({{5. / 12, -1. / 12}, {0.75, 0.25}, {0.75, 0.25}}))));
    BOOST_TEST(!filtered(methods::dormand_prince()));  // explicit
}

BOOST_AUTO_TEST_CASE(weights_that_see_no_error_of_a_quadrature_are_refused) {
    const auto m = sayfy_aburub();
    BOOST_TEST(sc::blind_to_quadrature(m, row(m.b - m.b_embedded)));
    const auto wave = [](double t, const V1&, V1& f) { f[0] = std::cos(t); };
    const auto run = [&](const method& by, double step) {
        return sc::integrate(by, wave, V1(0.0), 0, 10, {.rtol = 1e-6, .atol = 1e-6, .fixed_step = step});
    };
    try {
        run(m, 0);
        BOOST_TEST(false);
    } catch (const std::invalid_argument& e) {
        BOOST_TEST(std::string(e.what()).find("b_embedded") != std::string::npos);
    }
    // What the message recommends works; other pairs are served as they are.
    BOOST_TEST(std::abs(run(m, 0.05).y[0] - std::sin(10.0)) < 1e-6);
    for (const auto& by :
         {sc::step_doubling(m), methods::dormand_prince(), methods::sdirk_4_3(), methods::tr_bdf2()}) {
        BOOST_TEST(!sc::blind_to_quadrature(by, row(by.b - by.b_embedded)));
        const auto r = run(by, 0);
        BOOST_TEST(r.ok());
        BOOST_TEST(std::abs(r.y[0] - std::sin(10.0)) < 1e-4);
    }
}
