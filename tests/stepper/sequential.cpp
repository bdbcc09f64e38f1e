// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE sequential
#include "methods.hpp"
#include "outcome.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <stagecraft/integrate.hpp>
#include <stdexcept>

namespace sc = stagecraft;
using V1 = Eigen::Matrix<double, 1, 1>;
using method = sc::tableau<double>;

namespace {

// A nonlinear, non-autonomous equation with solution exp(sin t), and how often it was asked for what.
struct wave {
    mutable long jacobians = 0;
    void operator()(double t, const V1& y, V1& f) const {
        f[0] = y[0] * std::cos(t) - y[0] * y[0] + std::exp(2 * std::sin(t));
    }
    void jacobian(double t, const V1& y, Eigen::Matrix<double, 1, 1>& J) const {
        ++jacobians;
        J(0, 0) = std::cos(t) - 2 * y[0];
    }
};

// Kepler's ellipse of eccentricity 1/2, started at the pericentre: period 2 pi.
struct kepler {
    void operator()(double, const Eigen::Vector4d& y, Eigen::Vector4d& f) const {
        const double r = std::hypot(y[0], y[1]), c = 1 / (r * r * r);
        f << y[2], y[3], -c * y[0], -c * y[1];
    }
    void jacobian(double, const Eigen::Vector4d&, Eigen::Matrix4d&) const {
        throw std::logic_error("an explicit method asked for the Jacobian");
    }
};
const Eigen::Vector4d pericentre(0.5, 0, 0, std::sqrt(3.0));

double wave_error(const method& m, double h) {
    const auto r = sc::integrate(m, wave{}, V1(1.0), 0, 0.5, {.rtol = 1e-14, .atol = 1e-14, .fixed_step = h});
    BOOST_TEST(r.ok());
    return std::abs(r.y[0] - std::exp(std::sin(0.5)));
}

// Largest error of the continuous solution inside the steps, or of its derivative.
double inner_error(const method& m, double h, bool derivative) {
    double worst = 0;
    const auto look = [&](double t, const V1&, double step, const auto& output) {
        for (int k = 0; k < 8; ++k) {
            const double x = t - step * k / 8, exact = std::exp(std::sin(x));
            worst = std::max(worst, std::abs(derivative ? output.derivative(x)[0] - std::cos(x) * exact
                                                        : output(x)[0] - exact));
        }
    };
    sc::integrate(m, wave{}, V1(1.0), 0, 0.5, {.rtol = 1e-14, .atol = 1e-14, .fixed_step = h}, look);
    return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(fixed_steps_show_the_order) {
    const auto order = [](const method& m, double h) {
        return slope([&](double k) { return wave_error(m, k); }, h);
    };
    BOOST_TEST(order(methods::classical(), 0.02) == 4, boost::test_tools::tolerance(0.02));
    BOOST_TEST(order(methods::dormand_prince(), 0.02) == 5, boost::test_tools::tolerance(0.03));
    BOOST_TEST(order(methods::sdirk_4_3(), 0.02) == 4, boost::test_tools::tolerance(0.02));
    BOOST_TEST(order(methods::tr_bdf2(), 0.02) == 2, boost::test_tools::tolerance(0.02));
    BOOST_TEST(order(methods::dirk_of_two_diagonals(), 0.01) == 1, boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(only_implicit_stages_ask_for_a_jacobian) {
    const wave p;
    const auto free = sc::integrate(methods::dormand_prince(), p, V1(1.0), 0, 2);
    BOOST_TEST(free.ok());
    BOOST_TEST(p.jacobians == 0);
    BOOST_TEST(free.report.jacobians + free.report.factorisations + free.report.solves +
                   free.report.error_solves ==
               0);
    const auto bound = sc::integrate(methods::sdirk_4_3(), p, V1(1.0), 0, 2);
    BOOST_TEST(bound.ok());
    BOOST_TEST(p.jacobians > 0);
    BOOST_TEST(bound.report.jacobians == p.jacobians);
}

BOOST_AUTO_TEST_CASE(the_last_stage_is_the_first_of_the_next_step) {
    const auto fixed =
        sc::integrate(methods::dormand_prince(), kepler{}, pericentre, 0, 1, {.fixed_step = 0.01});
    BOOST_TEST(fixed.report.steps == 100);
    BOOST_TEST(fixed.report.f == 6 * 100 + 1);
    const auto r = sc::integrate(methods::dormand_prince(), kepler{}, pericentre, 0, 40,
                                 {.rtol = 1e-9, .initial_step = 1});
    BOOST_TEST(r.ok());
    BOOST_TEST(r.report.rejected() > 0);
    BOOST_TEST(r.report.f == 6 * (r.report.steps + r.report.rejected()) + 1);
    // without that property every step starts with an evaluation, which a rejection does not repeat
    const auto plain = sc::integrate(methods::classical(), kepler{}, pericentre, 0, 1, {.fixed_step = 0.01});
    BOOST_TEST(plain.report.f == 4 * 100);
}

BOOST_AUTO_TEST_CASE(errors_of_adaptive_explicit_steps_follow_the_tolerance) {
    double last = 1;
    for (const double tol : {1e-4, 1e-6, 1e-8, 1e-10}) {
        const auto r = sc::integrate(methods::dormand_prince(), kepler{}, pericentre, 0,
                                     2 * 3.14159265358979323846, {.rtol = tol, .atol = tol});
        BOOST_TEST(r.ok());
        const double error = (r.y - pericentre).norm();
        BOOST_TEST(error < 1000 * tol);  // the phase error of a whole period
        BOOST_TEST(error > 10 * tol);    // the steps are as long as the tolerance allows
        BOOST_TEST(error < last / 10);
        last = error;
    }
}

BOOST_AUTO_TEST_CASE(time_runs_backwards) {
    for (const method& m : {methods::dormand_prince(), methods::sdirk_4_3(), methods::tr_bdf2()}) {
        const auto forth = sc::integrate(m, wave{}, V1(1.0), 0, 1, {.rtol = 1e-7, .atol = 1e-7});
        const auto back = sc::integrate(m, wave{}, forth.y, 1, 0, {.rtol = 1e-7, .atol = 1e-7});
        BOOST_TEST(back.ok());
        BOOST_TEST(back.y[0] == 1, boost::test_tools::tolerance(1e-4));
        BOOST_TEST(back.y[0] != 1);
    }
}

BOOST_AUTO_TEST_CASE(the_continuous_solution_is_one_order_below_the_method) {
    // global error O(h^{q+1}) of a continuous solution of order q; the derivative one less. 4 of order 5:
    BOOST_TEST(slope([](double h) { return inner_error(methods::dormand_prince(), h, false); }, 0.02) == 5,
               boost::test_tools::tolerance(0.05));
    BOOST_TEST(slope([](double h) { return inner_error(methods::dormand_prince(), h, true); }, 0.02) == 4,
               boost::test_tools::tolerance(0.05));
    // 3 of order 4:
    BOOST_TEST(slope([](double h) { return inner_error(methods::classical(), h, false); }, 0.02) == 4,
               boost::test_tools::tolerance(0.05));
    BOOST_TEST(slope([](double h) { return inner_error(methods::sdirk_4_3(), h, false); }, 0.02) == 4,
               boost::test_tools::tolerance(0.05));
    // limited by the method
    BOOST_TEST(slope([](double h) { return inner_error(methods::tr_bdf2(), h, false); }, 0.02) == 2,
               boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(a_method_that_cannot_do_what_is_asked_is_named) {
    const auto said = [](const method& m, double step) { return refusal(m, wave{}, V1(1.0), step); };
    BOOST_TEST(said(methods::classical(), 0.1) == "success");
    BOOST_TEST(has(said(methods::classical(), 0), "method has no embedded weights"));
    BOOST_TEST(said(methods::dormand_prince(), 0) == "success");
    method m = methods::classical();
    m.c.setZero();
    BOOST_TEST(has(said(m, 0.1), "method.c is zero and method.A is not: set c = A 1"));
    m = methods::classical();
    m.b *= 0.5;
    BOOST_TEST(has(said(m, 0.1), "method.b must sum to one"));
    m = methods::classical();
    m.b_embedded = Eigen::VectorXd::Constant(4, 0.5);
    BOOST_TEST(has(said(m, 0), "method.b_embedded must sum to one"));
    m.b_embedded = m.b;
    BOOST_TEST(has(said(m, 0), "method.b_embedded must differ from b"));
    m.b_embedded = Eigen::VectorXd::Constant(3, 1.0 / 3);
    BOOST_TEST(has(said(m, 0), "method.b_embedded"));
    m = methods::classical();
    m.A(2, 1) = std::numeric_limits<double>::quiet_NaN();
    BOOST_TEST(has(said(m, 0.1), "method must have finite entries"));
    m = methods::classical();
    m.c.resize(3);
    BOOST_TEST(has(said(m, 0.1), "method.c"));
    m = methods::classical();
    m.A.resize(4, 3);
    BOOST_TEST(has(said(m, 0.1), "method.A"));
    BOOST_TEST(has(said(method{}, 0.1), "at least one stage"));
}

BOOST_AUTO_TEST_CASE(explicit_steps_end_honestly) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto f = [nan](double t, const V1& y, V1& out) { out[0] = t > 1 ? nan : -y[0]; };
    for (const double step : {0.0, 0.03}) {
        const auto r = sc::integrate(methods::dormand_prince(), f, V1(1.0), 0, 2, {.fixed_step = step});
        BOOST_TEST(sc::name(r.status) == "non_finite");
        BOOST_TEST(r.t <= 1);
        BOOST_TEST(r.t > 0.9);
        BOOST_TEST(r.y[0] == std::exp(-r.t), boost::test_tools::tolerance(1e-4));
    }
    const auto pole = [](double, const V1& y, V1& out) { out[0] = y[0] * y[0]; };
    const auto r = sc::integrate(methods::dormand_prince(), pole, V1(1.0), 0, 2);
    BOOST_TEST(!r.ok());
    BOOST_TEST(r.t <= 1 + 1e-5);
    BOOST_TEST(r.t > 0.999);
}

BOOST_AUTO_TEST_CASE(long_double_reaches_beyond_double) {
    using V = Eigen::Matrix<long double, 1, 1>;
    const auto f = [](long double, const V& y, V& out) { out[0] = -y[0]; };
    const auto r = sc::integrate(methods::dormand_prince<long double>(), f, V(1.0L), 0, 1,
                                 {.rtol = 1e-17L, .atol = 1e-17L});
    BOOST_TEST(r.ok());
    const long double error = std::abs(r.y[0] - std::exp(-1.0L));
    BOOST_TEST(error < 1e-17L);
}
