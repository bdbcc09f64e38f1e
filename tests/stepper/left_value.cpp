// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE left_value
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stdexcept>

#include "methods.hpp"

// f at the left end of a step: when it is asked for, and what becomes of it where something fails.

namespace sc = stagecraft;
using V = Eigen::Matrix<double, 1, 1>;

BOOST_AUTO_TEST_CASE(a_singular_newton_matrix_leaves_the_left_slope_known) {
    // J(y0) = 1/(h a) exactly: continuation in the step size solves the stages, from the slope of this step.
    struct saturation {
        double lambda;
        void operator()(double, const V& y, V& f) const { f[0] = 1 + lambda * std::tanh(100 * y[0]) / 100; }
        void jacobian(double, const V& y, V& J) const {
            J[0] = lambda / (std::cosh(100 * y[0]) * std::cosh(100 * y[0]));
        }
    };
    const auto method = methods::tr_bdf2();
    const double h = 0.1, lambda = 1 / (h * method.A(1, 1));
    const auto at = [&](double l) {
        const auto r = sc::integrate(method, saturation{l}, V(0.), 0, h, {.fixed_step = h});
        BOOST_TEST(r.ok());
        return r.y[0];
    };
    BOOST_TEST(at(lambda) == at(lambda * (1 + 1e-3)), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(finite_differences_use_the_value_of_the_same_state) {
    // f becomes stiff between the last node of a step and its end: the next step needs a new Jacobian.
    struct kick {
        void operator()(double t, const V& y, V& f) const {
            f[0] = t < 0.945 ? 1 - 1e-6 * y[0] : 1e5 * (1 - y[0]);
        }
    };
    struct kick_with_jacobian : kick {
        void jacobian(double t, const V&, V& J) const { J[0] = t < 0.945 ? -1e-6 : -1e5; }
    };
    const sc::options<double> o{.fixed_step = 0.05};
    const auto differences = sc::integrate(sc::gauss<2>(), kick{}, V(0.), 0, 2, o),
               exact = sc::integrate(sc::gauss<2>(), kick_with_jacobian{}, V(0.), 0, 2, o);
    BOOST_TEST(differences.ok());
    BOOST_TEST(differences.report.jacobians == exact.report.jacobians);
    BOOST_TEST(differences.report.factorisations == exact.report.factorisations);
    BOOST_TEST(std::abs(differences.y[0] - exact.y[0]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(what_is_thrown_leaves_observers_and_state_together) {
    const auto midpoint = methods::rows<double>({{}, {0.5}, {0, 1}});
    const auto f = [](double t, const V& y, V& out) {
        if (t > 0.29) throw std::runtime_error("beyond");
        out = -y;
    };
    sc::solution<V> y;
    const auto r = sc::integrate(midpoint, f, V(1.), 0, 1, {.fixed_step = 0.1}, y);
    BOOST_TEST(sc::name(r.status) == "function_threw");
    BOOST_TEST(y.t1() == r.t);
    BOOST_TEST(y.steps() == r.report.steps);
    sc::output_times<V> times({0.1, 0.2, 0.3});
    const auto at_times = sc::integrate(midpoint, f, V(1.), 0, 1, {.fixed_step = 0.1}, times);
    BOOST_TEST(times.time(times.filled() - 1) == at_times.t);
}

BOOST_AUTO_TEST_CASE(a_run_goes_on_where_something_was_thrown_once) {
    for (const double step : {0.0, 0.1})
        for (const auto& method : {methods::rows<double>({{}, {0.5}, {0, 1}}), methods::sdirk_4_3()}) {
            if (step == 0 && method.b_embedded.size() == 0) continue;
            for (const int call : {1, 2, 3, 7, 12, 17}) {  // in start(), in a stage, at the end of a step
                const auto run_through = [&](int bad) {
                    int calls = 0, thrown = 0;
                    auto f = [&](double, const V& y, V& out) {
                        if (++calls == bad) {
                            out[0] = 7;
                            throw std::runtime_error("once");
                        }
                        out = -y;
                    };
                    sc::integrator<sc::tableau<double>, decltype(f), V> run(
                        method, f, V(1.), 0, 1, {.rtol = 1e-6, .atol = 1e-6, .fixed_step = step});
                    for (bool more = true; more;) try {
                            more = run.step();
                        } catch (const std::runtime_error&) {
                            ++thrown;
                        }
                    BOOST_TEST(thrown == (bad > 0));
                    BOOST_TEST(sc::name(run.status()) == "success");
                    return run.y()[0];
                };
                BOOST_TEST(std::abs(run_through(call) - run_through(0)) < 1e-7);
            }
        }
}
