// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE jumps_back
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/sensitivity/adjoint.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "jumping.hpp"

// Gradients across what changes the state or f on the way: at(), event() and break points. Truth: closed forms.
namespace sc = stagecraft;
using Eigen::MatrixXd, Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;

namespace {

using one = Eigen::Matrix<double, 1, 1>;
const auto decays = [](const auto&, const auto& y, const auto& p, auto& f) { f[0] = -p[0] * y[0]; };

}  // namespace

BOOST_AUTO_TEST_CASE(gradients_across_doses) {
    // y' = -k y from a; y := y + d y at t = 0, 1 and 2; so y = a (1 + d)^n exp(-k t), n doses up to t.
    const double k = 0.6, d = 0.4, a = 1.7;
    const auto dose = [](const auto&, auto& y, const auto& p) { y[0] += p[1] * y[0]; };
    const auto changes = std::tuple(sc::at({0.0, 2.0}, dose), sc::at({1.0}, dose));
    const auto functionals = std::tuple(
        sc::at_end([](const auto& y) { return y[0]; }),
        sc::sum_over(std::vector<double>{0, 0.5, 1, 2}, [](auto, const auto& y) { return y[0] * y[0]; }),
        sc::integral_of([](const auto&, const auto& y) { return y[0]; }));
    const auto y = [&](int n, double t) { return a * std::pow(1 + d, n) * std::exp(-k * t); };
    Eigen::Matrix<double, 2, 3> dp = Eigen::Matrix<double, 2, 3>::Zero();
    Eigen::RowVector3d dy0 = Eigen::RowVector3d::Zero(), value = dy0;
    const auto add = [&](int column, int n, double t, bool squared) {
        const double x = y(n, t), g = squared ? 2 * x : 1;
        value[column] += squared ? x * x : x;
        dp(0, column) += -t * x * g;
        dp(1, column) += n * x / (1 + d) * g;
        dy0[column] += x / a * g;
    };
    add(0, 3, 2, false);
    add(1, 1, 0, true), add(1, 1, 0.5, true), add(1, 2, 1, true), add(1, 3, 2, true);
    for (int n = 1; n <= 2; ++n) {  // the integral from n - 1 to n: (y(n - 1) - y(n)) / k
        const double b = y(n, n - 1), e = y(n, n), part = (b - e) / k;
        value[2] += part;
        dp(0, 2) += (-(n - 1) * b + n * e) / k - part / k;
        dp(1, 2) += n * part / (1 + d);
        dy0[2] += part / a;
    }
    for (const double tol : tolerances) {
        const auto r = sc::adjoint_gradient_with_events(radau, decays, one(a), Vector2d(k, d), 0, 2, changes,
                                                        functionals, to(tol));
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.value.transpose(), value) < 100 * tol);
        BOOST_TEST(distance(r.dp, dp) < 300 * tol);
        BOOST_TEST(distance(r.dy0, dy0) < 100 * tol);
        BOOST_TEST(r.dp_error.allFinite());
        BOOST_TEST(distance(r.dp, dp) < 3 * r.dp_error.maxCoeff() + 1e-13);
    }
    // Nothing but a change.
    const auto r = sc::adjoint_gradient_with_events(radau, decays, one(a), Vector2d(k, d), 0, 0,
                                                    sc::at({0.0}, dose), [](const auto& x) { return x[0]; });
    BOOST_TEST(r.dp[1] == a);
    BOOST_TEST(r.dy0[0] == 1 + d);
}

BOOST_AUTO_TEST_CASE(gradients_across_break_points) {
    const auto f = [](const auto& t, const auto& y, const auto& p, auto& out) {
        out[0] = (t < 1 ? p[0] : p[1]) * y[0];
    };
    for (const double tol : tolerances) {
        sc::options<double> o = to(tol);
        o.break_points = {1.0};
        const auto r = sc::adjoint_gradient(
            radau, f, one(1), Vector2d(0.5, -1), 0, 3, [](const auto& y) { return y[0]; }, o);
        const double y = std::exp(0.5 - 2);
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.dp, Vector2d(y, 2 * y)) < 10 * tol);
        BOOST_TEST(r.dp_error.maxCoeff() < 10 * tol);
    }
}

BOOST_AUTO_TEST_CASE(height_of_a_ball_after_some_bounces) {
    // As in jumps.cpp: T_k = t_0 (1 + 2e + ... + 2e^{k-1}), t_0 = sqrt(2h/g), the speed behind is e^k g t_0.
    const double g = 9.81, e = 0.8, h = 1.3, t0 = std::sqrt(2 * h / g);
    const auto falls = [](const auto&, const auto& y, const auto& p, auto& f) { f << y[1], -p[0]; };
    const auto floor =
        sc::event([](const auto&, const auto& y) { return y[0]; }, {.direction = sc::crossing::falling},
                  [](const auto&, auto& y, const auto& p) { y[1] *= -p[1]; });
    const auto functionals =
        std::tuple(sc::at_end([](const auto& y) { return y[0]; }),
                   sc::integral_of([](const auto&, const auto& y) { return y[1] * y[1]; }));
    for (const int k : {1, 3, 9}) {
        double sum = 1, by_e = 0;
        for (int j = 1; j < k; ++j) sum += 2 * std::pow(e, j), by_e += 2 * j * std::pow(e, j - 1);
        const double t1 = t0 * sum + t0 * std::pow(e, k) / 2;
        const Eigen::RowVector3d dt0(-t0 / (2 * g), 0, t0 / (2 * h)), dg(1, 0, 0), de(0, 1, 0);
        const double u = t1 - t0 * sum, v = std::pow(e, k) * g * t0;
        const Eigen::RowVector3d du = -sum * dt0 - t0 * by_e * de,
                                 dv = std::pow(e, k) * (t0 * dg + g * dt0) +
                                      k * std::pow(e, k - 1) * g * t0 * de,
                                 dy = u * dv + (v - g * u) * du - u * u / 2 * dg;
        // The integral of v^2 over a parabola from speed v to w is (v^3 - w^3)/(3 g).
        const auto cube = [](double x) { return x * x * x; };
        const double w = v - g * u;
        double flights = cube(g * t0);
        Eigen::RowVector3d dflights = 3 * g * t0 * g * t0 * (t0 * dg + g * dt0);
        for (int j = 1; j < k; ++j) {
            const double x = std::pow(e, j) * g * t0;
            const Eigen::RowVector3d dx =
                std::pow(e, j) * (t0 * dg + g * dt0) + j * std::pow(e, j - 1) * g * t0 * de;
            flights += 2 * cube(x), dflights += 6 * x * x * dx;
        }
        flights += cube(v) - cube(w);
        dflights += 3 * v * v * dv - 3 * w * w * (dv - u * dg - g * du);
        const Eigen::RowVector3d dI = dflights / (3 * g) - flights / (3 * g * g) * dg;
        const auto r = sc::adjoint_gradient_with_events(radau, falls, Vector2d(h, 0), Vector2d(g, e), 0, t1,
                                                        floor, functionals, to(1e-8));
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.dp.col(0), dy.head(2).transpose()) < 1e-10);
        BOOST_TEST(std::abs(r.dy0(0, 0) - dy[2]) < 1e-10);
        BOOST_TEST(std::abs(r.value[1] - flights / (3 * g)) < 1e-10);
        BOOST_TEST(distance(r.dp.col(1), dI.head(2).transpose()) < 1e-9);
        BOOST_TEST(std::abs(r.dy0(0, 1) - dI[2]) < 1e-9);
        BOOST_TEST(std::isnan(r.dp_error(0, 0)));
    }
    const auto rest = sc::adjoint_gradient_with_events(radau, falls, Vector2d(1, 0), Vector2d(9.81, 0.5), 0,
                                                       10, floor, [](const auto& y) { return y[0]; });
    BOOST_TEST((rest.status == sc::status::chattering));
}

namespace {

// y_1' = -a y_1, and -b y_1 from y_1 = s on; y_2' = y_1; p = (a, b, s).
struct two_fields {
    bool beyond = false;
    const bool* elsewhere = nullptr;
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P& p, F& f) const {
        if (beyond || (elsewhere && *elsewhere))
            f[0] = -p[1] * y[0];
        else
            f[0] = -p[0] * y[0];
        f[1] = y[0];
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(gradients_across_a_switch) {
    // tau = ln(1/s)/a, y_1 = s exp(-b (t - tau)), y_2 = (1 - s)/a + (s - y_1)/b.
    const double a = 1.5, b = 0.4, s = 0.3, t1 = 2, tau = std::log(1 / s) / a,
                 y = s * std::exp(-b * (t1 - tau));
    const Vector3d dtau(-tau / a, 0, -1 / (a * s)), ds(0, 0, 1), da(1, 0, 0), db(0, 1, 0);
    const Vector3d dy = y / s * ds - y * (t1 - tau) * db + y * b * dtau;
    MatrixXd S(3, 2);
    S << dy, -ds / a - (1 - s) / (a * a) * da + (ds - dy) / b - (s - y) / (b * b) * db;
    const auto level = [](const auto&, const auto& x, const auto& p) { return x[0] - p[2]; };
    const auto change =
        sc::sensitivity_event(level, {}, sc::detail::no_jump(), [](auto& problem) { problem.beyond = true; });
    const auto functionals = std::tuple(sc::at_end([](const auto& x) { return x[0]; }),
                                        sc::at_end([](const auto& x) { return x[1]; }));
    for (const double tol : tolerances) {
        const auto r = sc::adjoint_gradient_with_events(
            radau, two_fields{}, Vector2d(1, 0), Vector3d(a, b, s), 0, t1, change, functionals, to(tol));
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.dp, S) < 100 * tol);
    }
    // An action that sets the side does not unset it on the way back.
    bool beyond = false;
    const auto sets = sc::event(level, {}, [&](const auto&, auto&) { beyond = true; });
    const auto r = sc::adjoint_gradient_with_events(radau, two_fields{false, &beyond}, Vector2d(1, 0),
                                                    Vector3d(a, b, s), 0, t1, sets, functionals);
    BOOST_TEST(says(refusal(r), "f is not what it was"));
    // A terminal event: the end is at tau, y_2 = (1 - s)/a there, and the integral of 1 is tau.
    const auto ends = sc::sensitivity_event(level, {.terminal = true});
    const auto r2 = sc::adjoint_gradient_with_events(
        radau, two_fields{}, Vector2d(1, 0), Vector3d(a, b, s), 0, t1, ends,
        std::tuple(sc::at_end([](const auto& x) { return x[1]; }),
                   sc::integral_of([](const auto&, const auto& x) { return 1 + 0 * x[0]; })),
        to(1e-9));
    BOOST_TEST((r2.status == sc::status::event));
    BOOST_TEST(std::abs(r2.t - tau) < 1e-7);
    BOOST_TEST(distance(r2.dp.col(0), -ds / a - (1 - s) / (a * a) * da) < 1e-7);
    BOOST_TEST(distance(r2.dp.col(1), dtau) < 1e-7);
    BOOST_TEST(std::abs(r2.value[1] - tau) < 1e-7);
    const auto beyond_the_end = sc::adjoint_gradient_with_events(
        radau, two_fields{}, Vector2d(1, 0), Vector3d(a, b, s), 0, t1, ends,
        sc::sum_over(std::vector<double>{1.5}, [](auto, const auto& x) { return x[0]; }));
    BOOST_TEST(says(refusal(beyond_the_end), "before the last time of sum_over()"));
}

namespace {

// y' = -z, 0 = z - k y; the dose adds d to y.
struct algebraic {
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P& p, F& f) const {
        f[0] = -y[1];
        f[1] = y[1] - p[0] * y[0];
    }
    Eigen::Matrix2d mass() const { return Vector2d(1, 0).asDiagonal(); }
};

}  // namespace

BOOST_AUTO_TEST_CASE(gradients_of_algebraic_components_behind_a_dose) {
    const double k = 0.7, d = 0.4;
    for (const double tol : tolerances)
        for (const double t1 : {1.0, 2.5}) {  // at the dose and later
            const auto r = sc::adjoint_gradient_with_events(
                radau, algebraic{}, Vector2d(1, k), Vector2d(k, d), 0, t1,
                sc::at({1.0}, [](const auto&, auto& y, const auto& p) { y[0] += p[1]; }),
                [](const auto& y) { return y[1]; }, to(tol));
            const double late = std::exp(-k * (t1 - 1)), y = std::exp(-k * t1) + d * late;
            BOOST_TEST(r.ok());
            BOOST_TEST(std::abs(r.value - k * y) < 10 * tol);
            BOOST_TEST(std::abs(r.dp[0] - (y - k * (t1 * std::exp(-k * t1) + (t1 - 1) * d * late))) <
                       30 * tol);
            BOOST_TEST(std::abs(r.dp[1] - k * late) < 30 * tol);
        }
}
