// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE solution
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/lobatto_iiic.hpp>
#include <stagecraft/coefficients/radau_ia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <stdexcept>
#include <string>

#include "../message.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

const sc::options<double> tight{.rtol = 1e-10, .atol = 1e-10};

// y = (sin t, cos t)
struct circle {
    template <class Vector>
    void operator()(double, const Vector& y, Vector& f) const {
        f << y[1], -y[0];
    }
    template <class Vector, class Matrix>
    void jacobian(double, const Vector&, Matrix& J) const {
        J << 0, 1, -1, 0;
    }
    bool constant_jacobian() const { return true; }
};

// Keeps every continuous polynomial as the run hands it out, and compares the solution with it afterwards.
template <class Vector, class Method>
void check(const Method& method, double t0, double t1, double bound) {
    const Vector y0 = Vector2d(std::sin(t0), std::cos(t0));
    sc::solution<Vector> y;
    struct seen {
        double t;
        Vector y, slope;
        bool end;
    };
    std::vector<seen> all;
    const auto record = [&](double t, const Vector& at_end, double h, const auto& output) {
        for (int k = 0; k < 7; ++k) {
            const double u = t - h + k * (h / 7);
            if (k > 0) all.push_back({u, output(u), output.derivative(u), false});
        }
        all.push_back({t, at_end, output.derivative(t), true});
    };
    const auto r = sc::integrate(method, circle{}, y0, t0, t1, tight, sc::observers(record, y));
    BOOST_TEST(r.ok());
    BOOST_TEST(y.steps() == r.report.steps);
    BOOST_TEST(y.t0() == t0);
    BOOST_TEST(y.t1() == t1);
    BOOST_TEST((y(t0) == y0));
    double error = 0, slope_error = 0, difference = 0, jump = 0;
    for (const auto& s : all) {
        const Vector value = y(s.t), slope = y.derivative(s.t);
        difference = std::max({difference, (value - s.y).norm(), (slope - s.slope).norm()});
        error = std::max(error, std::abs(value[0] - std::sin(s.t)));
        slope_error = std::max(slope_error, std::abs(slope[0] - std::cos(s.t)));
        if (s.end && s.t != t1) jump = std::max(jump, (y(std::nextafter(s.t, t1)) - value).norm());
    }
    BOOST_TEST(difference < 1e-13);
    BOOST_TEST(jump < 1e-14);
    BOOST_TEST(error < bound);
    BOOST_TEST(slope_error < 300 * bound);
    BOOST_TEST((y(t1) - r.y).norm() < 1e-15);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_solution_is_that_of_the_steps_and_continuous) {
    check<Vector2d>(sc::radau_iia<3>(), 0, 20, 1e-8);
    check<Vector2d>(sc::radau_iia<3>(), 20, 0, 1e-8);
    check<VectorXd>(sc::radau_iia<3>(), 0, 20, 1e-8);
}

BOOST_AUTO_TEST_CASE(methods_whose_first_node_is_the_left_end_are_kept_as_well) {
    check<Vector2d>(sc::lobatto_iiic<4>(), 0, 5, 1e-6);
    check<Vector2d>(sc::radau_ia<3>(), 0, 5, 1e-6);
}

// The node sets of three orders in one run.
BOOST_AUTO_TEST_CASE(a_run_of_variable_order_is_kept_whole) {
    check<Vector2d>(sc::radau_iia_variable(), 0, 20, 1e-7);
    check<VectorXd>(sc::radau_iia_variable(), 20, 0, 1e-7);
}

BOOST_AUTO_TEST_CASE(a_time_outside_of_the_run_is_named) {
    sc::solution<Vector2d> y;
    BOOST_TEST(message<std::out_of_range>([&] { y(0.5); }) ==
               "solution: t = 0.5 asked for before a run was made");
    sc::integrate(sc::radau_iia<3>(), circle{}, Vector2d(0, 1), 0, 2, tight, y);
    BOOST_TEST(message<std::out_of_range>([&] { y(2.5); }) == "solution: t = 2.5 is not between 0 and 2");
    BOOST_TEST(message<std::out_of_range>([&] { y(std::nextafter(0.0, -1.0)); }) != "no exception");
    BOOST_TEST(message<std::out_of_range>([&] { y.derivative(-1); }) ==
               "solution: t = -1 is not between 0 and 2");
    BOOST_TEST(message<std::out_of_range>([&] { y(std::numeric_limits<double>::quiet_NaN()); }) !=
               "no exception");
    BOOST_TEST(message<std::out_of_range>([&] { y(0), y(2), y.derivative(0), y.derivative(2); }) ==
               "no exception");
    // The next run replaces it, also backwards and without a step.
    sc::integrate(sc::radau_iia<3>(), circle{}, Vector2d(0, 1), 0, -1, tight, y);
    BOOST_TEST(message<std::out_of_range>([&] { y(0.5); }) == "solution: t = 0.5 is not between 0 and -1");
    BOOST_TEST(y(-0.5)[0] == std::sin(-0.5), boost::test_tools::tolerance(1e-7));
    sc::integrate(sc::radau_iia<3>(), circle{}, Vector2d(0, 1), 4, 4, tight, y);
    BOOST_TEST(y(4)[1] == 1);
    BOOST_TEST(message<std::out_of_range>([&] { y.derivative(4); }) ==
               "solution: a run without a step has no derivative");
}

BOOST_AUTO_TEST_CASE(a_terminal_event_ends_the_solution_where_it_ends_the_run) {
    for (const bool events_first : {true, false}) {
        sc::solution<Vector2d> y;
        auto top = sc::events<Vector2d>(
            sc::event([](double, const Vector2d& x) { return x[1]; }, {.terminal = true}));
        const auto r = events_first ? sc::integrate(sc::radau_iia<3>(), circle{}, Vector2d(0, 1), 0, 9, tight,
                                                    sc::observers(top, y))
                                    : sc::integrate(sc::radau_iia<3>(), circle{}, Vector2d(0, 1), 0, 9, tight,
                                                    sc::observers(y, top));
        BOOST_TEST(sc::name(r.status) == "event");
        BOOST_TEST(std::abs(r.t - std::acos(0.0)) < 1e-8);
        BOOST_TEST(y.t1() == r.t);
        BOOST_TEST((y(r.t) - r.y).norm() < 1e-15);
        BOOST_CHECK_THROW(y(std::nextafter(r.t, 9)), std::out_of_range);
    }
}
