// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE charge
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/charge.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/observe/at.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "../message.hpp"

// q(y)' = f(t, y) as it stands. Truth: closed forms, and sums of charges that f does not change.
namespace sc = stagecraft;
using Eigen::Vector2d, Eigen::VectorXd;

namespace {

const auto radau = sc::radau_iia<3>();
using one = Eigen::Matrix<double, 1, 1>;
sc::options<double> to(double tol) { return {.rtol = tol, .atol = tol}; }

// A capacitor of C (v + v^3/3) through a resistor: (1 + v^2) v' = -v/(RC), so that ln v + v^2/2 falls at the rate 1/(RC).
double discharged(double v0, double t) {
    const double goal = std::log(v0) + v0 * v0 / 2 - t;
    double v = v0;
    for (int k = 0; k < 100; ++k) v -= (std::log(v) + v * v / 2 - goal) / (1 / v + v);
    return v;
}
template <class Charge>
auto ring(Charge charge) {
    const auto currents = [](double t, const auto& v, auto& f) {
        const Eigen::Index n = v.size();
        for (Eigen::Index i = 0; i < n; ++i) f[i] = 0 * v[i];
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto current = (v[i] - v[(i + 1) % n]) * (1.0 + double(i)) + std::sin(5 * t + double(i));
            f[i] -= current;
            f[(i + 1) % n] += current;
        }
    };
    return sc::with_charge(charge, currents);
}
const auto cubic = [](const auto& v, auto& q) {
    for (Eigen::Index i = 0; i < v.size(); ++i) q[i] = v[i] + (1.0 + double(i)) * v[i] * v[i] * v[i];
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_nonlinear_capacitor_through_a_resistor) {
    for (const double unit : {1.0, 1e-12})  // farads, picofarads
        for (const double tol : {1e-4, 1e-7, 1e-10}) {
            const auto q = [unit](const auto& v, auto& out) {
                out[0] = unit * (v[0] + v[0] * v[0] * v[0] / 3);
            };
            const auto f = [unit](double, const auto& v, auto& out) { out[0] = -unit * v[0]; };
            const auto r = sc::integrate(radau, sc::with_charge(q, f), one(2), 0, 3, to(tol));
            const auto plain = [](double, const auto& v, auto& out) { out[0] = -v[0] / (1 + v[0] * v[0]); };
            const auto e = sc::integrate(radau, plain, one(2), 0, 3, to(tol));
            BOOST_TEST(r.ok());
            BOOST_TEST(std::abs(r.y[0] - discharged(2, 3)) < 10 * tol);
            BOOST_TEST(double(r.report.steps) <= 1.3 * double(e.report.steps) + 1);
            BOOST_TEST_MESSAGE(tol << ": " << r.report.steps << " steps, " << e.report.steps
                                   << " of the explicit form");
        }
    // In plain numbers, returned.
    const auto r =
        sc::integrate(radau,
                      sc::with_charge([](const one& v) -> one { return one(v[0] + v[0] * v[0] * v[0] / 3); },
                                      [](double, const one& v) -> one { return -v; }),
                      one(2), 0, 3, to(1e-7));
    BOOST_TEST(std::abs(r.y[0] - discharged(2, 3)) < 1e-6);
}

BOOST_AUTO_TEST_CASE(a_ring_keeps_its_charge) {
    const Eigen::Vector4d v0(1, -0.5, 2, 0.3);
    Eigen::Vector4d q0, q1;
    cubic(v0, q0);
    for (const double tol : {1e-3, 1e-6, 1e-9}) {
        const auto r = sc::integrate(radau, ring(cubic), v0, 0, 50, to(tol));
        BOOST_TEST(r.ok());
        cubic(r.y, q1);
        // What y leaves of q - q(y) is what Newton's iteration does, a fiftieth of the tolerance in the mean square of the
        // eight unknowns, times the capacitances; it does not add up with the steps.
        double most = 0;
        for (int i = 0; i < 4; ++i)
            most +=
                std::sqrt(8.0) * tol / 50 * (1 + std::abs(r.y[i])) * (1 + 3 * (1.0 + i) * r.y[i] * r.y[i]);
        BOOST_TEST(std::abs(q1.sum() - q0.sum()) < most);
        struct explicit_form {
            void operator()(double t, const Eigen::Vector4d& v, Eigen::Vector4d& f) const {
                ring(cubic).f(t, v, f);
                for (int i = 0; i < 4; ++i) f[i] /= 1 + 3 * (1.0 + i) * v[i] * v[i];
            }
        };
        const auto e = sc::integrate(radau, explicit_form{}, v0, 0, 50, to(tol));
        BOOST_TEST(double(r.report.steps) <= 1.3 * double(e.report.steps));
        BOOST_TEST((r.y - e.y).cwiseAbs().maxCoeff() < 100 * tol);
        BOOST_TEST_MESSAGE(tol << ": " << r.report.steps << " steps, " << e.report.steps
                               << " of the explicit form; charge off by " << q1.sum() - q0.sum());
    }
    const auto r = sc::integrate(radau, ring(cubic), VectorXd(v0), 0, 10, to(1e-6));
    BOOST_TEST(r.y.size() == 4);
}

BOOST_AUTO_TEST_CASE(observers_see_y) {
    const auto q = [](const auto& v, auto& out) { out[0] = v[0] + v[0] * v[0] * v[0] / 3; };
    const auto problem = sc::with_charge(q, [](double, const auto& v, auto& out) { out[0] = -v[0]; });
    sc::solution<one> y;
    sc::integrate(radau, problem, one(2), 0, 3, to(1e-8), y);
    for (const double t : {0.3, 1.1, 2.9}) BOOST_TEST(std::abs(y(t)[0] - discharged(2, t)) < 1e-5);
    auto watch =
        sc::events<one>(sc::event([](double, const one& v) { return v[0] - 1; }, {.terminal = true}));
    const auto stopped = sc::integrate(radau, problem, one(2), 0, 9, to(1e-8), watch);
    BOOST_TEST((stopped.status == sc::status::event));
    BOOST_TEST(std::abs(stopped.t - (std::log(2) + 1.5)) < 1e-6);
    BOOST_TEST(std::abs(stopped.y[0] - 1) < 1e-9);
    // The resistance is three times as large until t = 1.
    struct switched {
        void operator()(double t, const one& v, one& out) const { out[0] = -v[0] / (t < 1 ? 3 : 1); }
        std::vector<double> break_points() const { return {1.0}; }
        bool domain(double, const one& v) const { return v[0] > 0; }
    };
    const auto s = sc::integrate(radau, sc::with_charge(q, switched{}), one(2), 0, 3, to(1e-8));
    BOOST_TEST(std::abs(s.y[0] - discharged(2, 1.0 / 3 + 2)) < 1e-7);
    BOOST_TEST(s.report.steps < 40);
    BOOST_CHECK_THROW(sc::integrate(radau, sc::with_charge(q, switched{}), one(-1), 0, 3),
                      std::invalid_argument);
    // A pulse of voltage.
    const auto r = sc::integrate(radau, problem, one(2), 0, 3, to(1e-8),
                                 sc::at({1.0}, [](double, one& v) { v[0] += 1; }));
    BOOST_TEST(std::abs(r.y[0] - discharged(discharged(2, 1) + 1, 2)) < 1e-7);
}

BOOST_AUTO_TEST_CASE(nodes_without_capacitance_and_capacitors_that_float) {
    // v_0 - 2 ohm - v_1 - 1 ohm - ground, a capacitor at v_0 alone: v_1 = v_0/3, (1 + v_0^2) v_0' = -v_0/3.
    const auto at_node = [](const auto& v, auto& q) { q << v[0] + v[0] * v[0] * v[0] / 3, 0 * v[0]; };
    const auto grounded = [](const auto& v, auto& q) {
        q[0] = v[0] + v[0] * v[0] * v[0] / 3;
        q[1] = 0;
    };
    const auto currents = [](double, const auto& v, auto& f) {
        f << (v[1] - v[0]) / 2, (v[0] - v[1]) / 2 - v[1];
    };
    const auto r =
        sc::integrate(radau, sc::with_charge(grounded, currents), Vector2d(2, 2.0 / 3), 0, 3, to(1e-8));
    BOOST_TEST(r.ok());
    BOOST_TEST(std::abs(r.y[0] - discharged(2, 1)) < 1e-7);
    BOOST_TEST(std::abs(r.y[1] - discharged(2, 1) / 3) < 1e-7);
    const auto refused = [&](const auto& q) {
        return message([&] { sc::integrate(radau, sc::with_charge(q, currents), Vector2d(2, 0.5), 0, 3); });
    };
    const auto floats = [](const auto& v, auto& q) { q << v[0] - v[1], v[1] - v[0]; };
    BOOST_TEST(refused(floats).find("rank 1 of 2") != std::string::npos);
    // 0 v is NaN where v is: nothing says that it is constant.
    BOOST_TEST(refused(at_node).find("component 1 of q is written with y but does not change") !=
               std::string::npos);
}
