// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE output_methods
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/steps.hpp>
#include <stagecraft/tableaux/rounded.hpp>

#include "methods.hpp"

namespace sc = stagecraft;
using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

namespace {

// y = (sin t, cos t)
struct circle {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 2, 1>& y, Eigen::Matrix<S, 2, 1>& f) const {
        f[0] = y[1];
        f[1] = -y[0];
    }
    template <class S>
    void jacobian(const S&, const Eigen::Matrix<S, 2, 1>&, Eigen::Matrix<S, 2, 2>& J) const {
        J << S(0), S(1), S(-1), S(0);
    }
};

// Runs to 4 (with an event at every zero of y_0 and y_1) and returns the largest error of all that was put
// out.
template <class S, class Method>
S largest_error(const Method& method, const S& step, const S& pi) {
    using std::abs;
    using std::cos;
    using std::max;
    using std::sin;
    using vector = Eigen::Matrix<S, 2, 1>;
    sc::solution<vector> y;
    sc::output_times<vector> table({S(0), S(1) / 3, S(3), S(4)}, true);
    auto watch = sc::events<vector>(sc::event([](const S&, const vector& v) { return v[0]; }),
                                    sc::event([](const S&, const vector& v) { return v[1]; }));
    const auto r = sc::integrate(method, circle{}, vector(S(0), S(1)), S(0), S(4), {.fixed_step = step},
                                 sc::observers(y, table, watch));
    BOOST_TEST(r.ok());
    S error = S(0);
    const auto see = [&](const S& e) { error = max<S>(error, abs(e)); };
    for (int k = 0; k <= 97; ++k) see(y(S(4 * k) / 97)[0] - sin(S(4 * k) / 97));
    BOOST_TEST(table.filled() == 4);
    for (int i = 0; i < 4; ++i) {
        see(table.y(i)[0] - sin(table.time(i)));
        see((table.derivative(i)[0] - cos(table.time(i))) * step);
    }
    BOOST_REQUIRE(watch.found().size() == 2u);
    see(watch.found()[0].t - pi / 2);
    see(watch.found()[1].t - pi);
    // Located to the rounding of t, whatever the error of the solution.
    for (const auto& o : watch.found())
        BOOST_TEST(static_cast<double>(abs(o.y[o.event == 0 ? 0 : 1]) / std::numeric_limits<S>::epsilon()) <
                   16);
    return error;
}

}  // namespace

// Sequential and coupled methods: polynomials through other data, some with the slope at the left end.
BOOST_AUTO_TEST_CASE(output_of_methods_given_by_a_tableau) {
    const double pi = std::acos(-1.0);
    BOOST_TEST(largest_error(methods::classical(), 1. / 64, pi) < 1e-7);
    BOOST_TEST(largest_error(methods::sdirk_4_3(), 1. / 64, pi) < 1e-6);
    BOOST_TEST(largest_error(methods::tr_bdf2(), 1. / 256, pi) < 1e-5);
}

BOOST_AUTO_TEST_CASE(output_in_fifty_digits) {
    const fifty pi = boost::math::constants::pi<fifty>();
    const auto method = sc::tableaux::transformed<fifty>(sc::tableaux::family::radau_iia, 9);
    BOOST_TEST(static_cast<double>(largest_error<fifty>(method, fifty(1) / 8, pi)) < 1e-16);
    BOOST_TEST(static_cast<double>(largest_error<fifty>(method, fifty(1) / 32, pi)) < 1e-22);
}

BOOST_AUTO_TEST_CASE(steps_of_an_explicit_method_are_a_range_too) {
    using vector = Eigen::Vector2d;
    double t = 0;
    for (const auto& step :
         sc::steps(methods::classical(), circle{}, vector(0, 1), 0, 1, {.fixed_step = 0.1}))
        t = step.t;
    BOOST_TEST(t == 1);
}
