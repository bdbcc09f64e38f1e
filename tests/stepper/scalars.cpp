// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE scalars
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <boost/test/unit_test.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>
#include <stagecraft/tableaux/rounded.hpp>

namespace sc = stagecraft;
using fifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

namespace {

// y' = A y + a quadratic term, with solution (exp(-t), exp(-2 t)); one right-hand side for all scalars.
struct pair {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 2, 1>& y, Eigen::Matrix<S, 2, 1>& f) const {
        f[0] = -y[0];
        f[1] = -3 * (y[1] - y[0] * y[0]) - 2 * y[1];
    }
    template <class S>
    void jacobian(const S&, const Eigen::Matrix<S, 2, 1>& y, Eigen::Matrix<S, 2, 2>& J) const {
        J << S(-1), S(0), S(6 * y[0]), S(-5);
    }
};

template <class S>
S end_error(sc::tableaux::family f, int s, const sc::options<S>& o) {
    using std::abs;
    using std::exp;
    const auto method = sc::tableaux::transformed<S>(f, s);
    const auto r = sc::integrate(method, pair{}, Eigen::Matrix<S, 2, 1>(S(1), S(1)), 0, 1, o);
    BOOST_TEST(r.ok());
    return abs(r.y[1] - exp(S(-2)));
}

}  // namespace

BOOST_AUTO_TEST_CASE(long_double_reaches_beyond_double) {
    const long double tol = 1e-17L;
    const auto e = end_error<long double>(sc::tableaux::family::radau_iia, 5, {.rtol = tol, .atol = tol});
    BOOST_TEST(e < 2e-17L);
    BOOST_TEST(end_error<double>(sc::tableaux::family::radau_iia, 5, {.rtol = 1e-10, .atol = 1e-10}) < 1e-9);
}

BOOST_AUTO_TEST_CASE(fifty_digits_reach_the_tolerance) {
    const fifty tol("1e-30");
    BOOST_TEST(end_error<fifty>(sc::tableaux::family::radau_iia, 9, {.rtol = tol, .atol = tol}) < 10 * tol);
    const fifty loose("1e-12");
    BOOST_TEST(end_error<fifty>(sc::tableaux::family::radau_iia, 9, {.rtol = loose, .atol = loose}) > tol);
}

// Orders beyond what double can show: error ratios over h = 1/8 and 1/16 at 50 digits.
BOOST_AUTO_TEST_CASE(fixed_step_orders_show_at_50_digits) {
    const auto order = [](sc::tableaux::family f, int s) {
        const fifty tiny("1e-40");
        const auto error = [&](int n) {
            return end_error<fifty>(f, s, {.rtol = tiny, .atol = tiny, .fixed_step = fifty(1) / n});
        };
        return std::log2(static_cast<double>(error(256) / error(512)));
    };
    using enum sc::tableaux::family;
    BOOST_TEST(std::abs(order(radau_iia, 3) - 5) < 0.05);
    BOOST_TEST(std::abs(order(radau_iia, 5) - 9) < 0.05);
    BOOST_TEST(std::abs(order(gauss, 4) - 8) < 0.05);
    BOOST_TEST(std::abs(order(lobatto_iiic, 4) - 6) < 0.05);
    BOOST_TEST(std::abs(order(radau_ia, 4) - 7) < 0.05);
}

// y0 = cos t, y1 = -sin t by coarse steps: without the projections the invariant is off by 1e-7.
BOOST_AUTO_TEST_CASE(projections_keep_constraints_to_fifty_digits) {
    using std::abs;
    const auto method = sc::tableaux::transformed<fifty>(sc::tableaux::family::radau_iia, 3);
    const sc::options<fifty> o{.rtol = fifty("1e-12"), .atol = fifty("1e-12"), .fixed_step = fifty(1) / 4};
    const auto circle = [](const auto&, const auto& y, auto& g) { g[0] = y[0] * y[0] + y[1] * y[1] - 1; };
    auto onto = sc::projection_onto<1>(circle);
    const auto turning = sc::integrate(
        method,
        [](const auto&, const auto& y, auto& f) {
            f[0] = y[1];
            f[1] = -y[0];
        },
        Eigen::Matrix<fifty, 2, 1>(fifty(1), fifty(0)), 0, 1, o, onto);
    BOOST_TEST(turning.ok());
    BOOST_TEST(onto.corrections() == 4);
    BOOST_TEST(abs(fifty(turning.y.squaredNorm() - 1)) < fifty("1e-48"));

    // The same motion by a multiplier: v' = -z q and 0 = q v.
    const auto problem = sc::semi_explicit<4, 1>(
        [](const auto&, const auto& y, const auto& z, auto& f) {
            f[0] = y[2];
            f[1] = y[3];
            f[2] = -z[0] * y[0];
            f[3] = -z[0] * y[1];
        },
        [](const auto&, const auto& y, auto& g) { g[0] = y[0] * y[2] + y[1] * y[3]; });
    auto keep = sc::projection(problem);
    Eigen::Matrix<fifty, 5, 1> start;
    start << fifty(1), fifty(0), fifty(0), fifty(-1), fifty(1);
    const auto r = sc::integrate(method, problem, start, 0, 1, o, keep);
    BOOST_TEST(r.ok());
    BOOST_TEST(abs(fifty(r.y[0] * r.y[2] + r.y[1] * r.y[3])) < fifty("1e-48"));
}
