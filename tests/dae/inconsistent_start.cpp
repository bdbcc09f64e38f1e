// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE inconsistent_start
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <sstream>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/consistent.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/at.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/semi_explicit.hpp>
#include <stagecraft/problem/with.hpp>
#include <stagecraft/report_text.hpp>

// Algebraic components of index 1 that do not satisfy their equations at the start (a switch has been thrown): Radau IIA
// never uses their values, so the run succeeds from wherever Newton's iteration finds the right ones. Right values by
// elimination of z and DOP853 at 1e-13, or in closed form.

namespace sc = stagecraft;
using V = Eigen::VectorXd;

namespace {

using right_hand_side = std::function<void(double, const V&, V&)>;
struct dae {
    right_hand_side f;
    Eigen::MatrixXd M;
    void operator()(double t, const V& y, V& g) const { f(t, y, g); }
    const Eigen::MatrixXd& mass() const { return M; }
};
const Eigen::MatrixXd first_only = Eigen::Vector2d(1, 0).asDiagonal();

void ends_at(const char* what, const dae& problem, const V& y0, double t0, double t1, double right,
             double factor = 20) {
    for (const double tol : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
        const auto r = sc::integrate(sc::radau_iia<3>(), problem, y0, t0, t1, {.rtol = tol, .atol = tol});
        BOOST_TEST_CONTEXT(what << ", tol " << tol) {
            BOOST_TEST(name(r.status) == "success");
            BOOST_TEST(std::abs(r.y[0] - right) < factor * tol);
        }
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(linear_and_curved_equations_alike) {
    for (const auto& [a, right] : {std::pair{0.0, 1 - std::exp(-5.0)}, std::pair{1e-3, 0.9922707725},
                                   std::pair{1e-2, 0.9835232536}, std::pair{0.1, 0.9099072861}})
        ends_at(
            "0 = z + a z^2 - 1 from 0.9",
            {[a = a](double, const V& y, V& f) { f << y[1] - y[0], y[1] + a * y[1] * y[1] - 1; }, first_only},
            V{{0, 0.9}}, 0, 5, right);
    ends_at("all substrate is free",
            {[](double, const V& y, V& f) {
                 const double c = y[1] / (0.5 + y[1]);
                 f << -0.2 * c, y[1] + c - y[0];
             },
             first_only},
            V{{2, 2}}, 0, 5, 1.337786333);
}

BOOST_AUTO_TEST_CASE(far_from_the_constraints_the_iteration_is_damped) {
    const dae electrode{[](double, const V& y, V& f) {
                            f << -1.0 / 3600, 1 + std::sqrt(y[0] * (1 - y[0])) * std::sinh(y[1] / 0.0514);
                        },
                        first_only};
    ends_at("electrode", electrode, V{{0.9, 0}}, 0, 1800, 0.4);
    const dae swing{[](double, const V& y, V& f) {
                        const double d = y[0], w = y[1], v = y[2], p = y[3], b = 1.8;
                        f << 100 * M_PI * w, (0.8 - p - 2 * w) / 7, p - 1.1 * v * b * std::sin(d),
                            v - 1 + 0.1 * v * v * b * (1 - std::cos(d));
                    },
                    Eigen::Vector4d(1, 1, 0, 0).asDiagonal()};
    ends_at("a fault is cleared", swing, V{{0.768, 0.01428, 0.9944, 0.152}}, 0.25, 5, 0.3909580968, 100);
    // M is not diagonal: the difference of two nodes has no derivative. z = y_0 - y_1: z + z^3 = 2, z = 1.
    Eigen::MatrixXd coupled{{1, 1}, {1, 1}};
    const dae nodes{[](double, const V& y, V& f) {
                        const double z = y[0] - y[1], s = y[0] + y[1], g = z + z * z * z - 2;
                        f << -s + g, -s - g;  // s' = -s
                    },
                    coupled};
    ends_at("two nodes", nodes, V{{2, 2}}, 0, 1, (4 * std::exp(-1.0) + 1) / 2);
}

BOOST_AUTO_TEST_CASE(where_there_is_no_solution_near_the_status_names_the_equation) {
    const dae none{[](double, const V& y, V& f) { f << y[1] - y[0], y[1] * y[1] + 1 + y[0]; }, first_only};
    const auto r = sc::integrate(sc::radau_iia<3>(), none, V{{0, 0.5}}, 0, 1);
    BOOST_TEST(name(r.status) == "inconsistent_start");
    BOOST_TEST(r.t == 0);
    BOOST_TEST((r.y == V{{0, 0.5}}));
    BOOST_TEST(r.report.unmet_equation == 1);
    BOOST_TEST(r.report.unmet_rest == 1.25);
    BOOST_TEST(r.report.unmet_tolerances > 1000);
    std::ostringstream text;
    print(text, r);
    BOOST_TEST(text.str().find("equation 1 (counted from 0) leaves 1.25") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_consistent_start_may_be_asked_for) {
    // y' = -y z, 0 = z + z^3 - y: with w = z, (1 + 3 w^2) w' = -(w + w^3) w, so that 1/w - 2 atan(w) - t is constant.
    const dae root{[](double, const V& y, V& f) { f << -y[0] * y[1], y[1] * y[1] * y[1] + y[1] - y[0]; },
                   first_only};
    const auto constant = [](double t, double w) { return 1 / w - 2 * std::atan(w) - t; };
    const auto rest = [](const V& y) { return std::abs(y[1] * y[1] * y[1] + y[1] - y[0]); };
    const double w0 = std::cbrt(0.5 + std::sqrt(31 / 108.0)) + std::cbrt(0.5 - std::sqrt(31 / 108.0));
    for (const double tol : {1e-3, 1e-6, 1e-9}) {
        const sc::options<double> o{.rtol = tol, .atol = tol, .consistent_start = true};
        sc::solution<V> path;
        const auto by_radau = sc::integrate(sc::radau_iia<3>(), root, V{{1, 0.5}}, 0, 1, o, path);
        const auto by_gauss =
            sc::integrate(sc::gauss<3>(), root, V{{1, 0.5}}, 0, 1, o);  // which never forgets z0
        BOOST_TEST((by_radau.ok() && by_gauss.ok()));
        BOOST_TEST(rest(path(0)) < 1e-14);  // observers see where the run begins, to rounding
        BOOST_TEST(std::abs(path(0)[1] - w0) < 1e-14);
        BOOST_TEST(path(0)[0] == 1);
        for (const V& y : {by_radau.y, by_gauss.y})
            BOOST_TEST(std::abs(constant(1, y[1]) - constant(0, w0)) < 30 * tol);
        BOOST_TEST(by_radau.report.rejected_error + by_radau.report.rejected_newton == 0);
    }
    // Behind a change as well, before anybody sees it.
    double largest = 0;
    auto dose = sc::at({0.5}, [](double, V& y) { y[0] += 1; });
    const auto r = sc::integrate(sc::radau_iia<3>(), root, V{{1, 0.5}}, 0, 1, {.consistent_start = true},
                                 sc::observers(dose, [&](double t, const V& y) {
                                     if (t >= 0.5) largest = std::max(largest, rest(y));
                                     return true;
                                 }));
    BOOST_TEST(r.ok());
    BOOST_TEST(largest < 1e-5);
    // Index 2 by the rules of consistent_initial_values; the multiplier of the unit circle is 0.
    const auto circle = sc::semi_explicit<2, 1>(
        [](const auto&, const auto& y, const auto& z, auto& out) {
            out[0] = -y[1] + y[0] * z[0];
            out[1] = y[0] + y[1] * z[0];
        },
        [](const auto&, const auto& y, auto& out) { out[0] = y[0] * y[0] + y[1] * y[1] - 1.0; });
    using Eigen::Vector3d;
    sc::solution<Vector3d> turn;
    BOOST_TEST(sc::integrate(sc::radau_iia<3>(), circle, Vector3d(1.1, 0.2, 5), 0, 1,
                             {.consistent_start = true}, turn)
                   .ok());
    const Vector3d first = turn(0), right = sc::consistent_initial_values(circle, 0, Vector3d(1.1, 0.2, 5)).y;
    BOOST_TEST((first - right).norm() == 0);
    BOOST_TEST(std::abs(first.head(2).norm() - 1) < 1e-12);
    BOOST_TEST(std::abs(first[2]) < 1e-12);
    // Where there are no such values, and where nothing asks for them.
    const dae none{[](double, const V& y, V& f) { f << y[1] - y[0], y[1] * y[1] + 1 + y[0]; }, first_only};
    const auto refused =
        sc::integrate(sc::radau_iia<3>(), none, V{{0, 0.5}}, 0, 1, {.consistent_start = true});
    BOOST_TEST(name(refused.status) == "inconsistent_start");
    BOOST_TEST((refused.y == V{{0, 0.5}}));
    const auto regular = [](double, const V& y, V& f) { f = -y; };
    BOOST_TEST(sc::integrate(sc::radau_iia<3>(), regular, V{{1, 2}}, 0, 1, {.consistent_start = true}).y ==
               sc::integrate(sc::radau_iia<3>(), regular, V{{1, 2}}, 0, 1).y);
}

// A voltage source across a node with nothing but a capacitor: its current z = y' is of index 2, though nobody says so. At
// its jump, where the slope of the voltage does, steps become so short that the rounding of y, divided by h, is more than
// z may be off by: halving makes that worse. Where the tolerance is below rounding at any step the run fails as before.
BOOST_AUTO_TEST_CASE(rounding_in_a_current_that_is_of_index_2_ends_no_run) {
    const Eigen::MatrixXd M = Eigen::Vector3d(1, 1, 0).asDiagonal();
    long at_rounding = 0;
    for (const double offset : {0.0, 1.0, 1e3, 1e5, 1e7})
        for (const double tol : {1e-5, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12}) {
            const auto voltage = [=](double t) { return offset + std::sin(t) + std::max(0.0, t - 0.5); };
            const dae node{[&](double t, const V& y, V& f) { f << y[2] - y[0], y[2], y[1] - voltage(t); }, M};
            const auto r =
                sc::integrate(sc::radau_iia<3>(), node, V{{0, offset, 1}}, 0, 2, {.rtol = tol, .atol = tol});
            BOOST_TEST_CONTEXT("offset " << offset << ", tol " << tol) {
                if (tol > 1e-12 && std::max(1.0, offset) < 1.1e12 * tol)
                    BOOST_TEST(name(r.status) == "success");
                if (offset == 1e5 && tol == 1e-12) BOOST_TEST(!r.ok());
                if (r.ok()) BOOST_TEST(std::abs(r.y[2] - std::cos(2.0) - 1) < std::max(100 * tol, 1e-8));
            }
            at_rounding += r.report.at_rounding;
        }
    BOOST_TEST(at_rounding > 0);
}

// A diode clamps z: its equation becomes k times as steep where z passes a. Newton's iteration with the slope before the kink
// multiplies its error by -k, whatever the step; the three stages of a step lie on both sides of it. Against the equation
// with z eliminated; the step across the kink is estimated at a lower order.
BOOST_AUTO_TEST_CASE(kinks_of_an_algebraic_equation_are_passed) {
    for (const double k : {20.0, 120.0, 1200.0, 8000.0})
        for (const double a : {0.15, 0.25, 0.33})
            for (const double w : {2.0, 5.0}) {
                const dae clamped{[=](double t, const V& y, V& f) {
                                      f << std::sin(w * t) - y[1],
                                          y[1] + k * std::max(0.0, y[1] - a) - 1.5 * y[0];
                                  },
                                  first_only};
                const auto eliminated = [=](double t, const V& y, V& f) {
                    const double x = 1.5 * y[0];
                    f[0] = std::sin(w * t) - (x <= a ? x : (x + k * a) / (1 + k));
                };
                const double right = sc::integrate(sc::radau_iia<3>(), eliminated, V{{0}}, 0, 1,
                                                   {.rtol = 1e-10, .atol = 1e-10})
                                         .y[0];
                for (const double tol : {1e-4, 1e-7}) {
                    const auto r = sc::integrate(sc::radau_iia<3>(), clamped, V{{0, 0}}, 0, 1,
                                                 {.rtol = tol, .atol = tol});
                    BOOST_TEST_CONTEXT("k " << k << ", a " << a << ", w " << w << ", tol " << tol) {
                        BOOST_TEST(name(r.status) == "success");
                        BOOST_TEST(std::abs(r.y[0] - right) < 200 * tol);
                    }
                }
            }
}
