// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE jumps
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/sensitivity/forward.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "jumping.hpp"

// S behind what changes the state or f on the way: at() and event() in runs of sensitivities. Truth: closed forms.
namespace sc = stagecraft;
using Eigen::MatrixXd, Eigen::Vector2d, Eigen::Vector3d, Eigen::Vector4d, Eigen::VectorXd;

namespace {

const auto falls = [](const auto&, const auto& y, const auto& p, auto& f) { f << y[1], -p[0]; };
const auto height = [](const auto&, const auto& y) { return y[0]; };

// A ball dropped from h bounces at T_k = t_0 (1 + 2e + ... + 2e^{k-1}), t_0 = sqrt(2h/g), and leaves with e^k g t_0.
struct bounces {
    int k;
    double g, e, h;
    Eigen::Matrix<double, 2, 3> S(double t) const {  // by g, e, h
        const double t0 = std::sqrt(2 * h / g);
        double sum = 1, by_e = 0;
        for (int j = 1; j < k; ++j) sum += 2 * std::pow(e, j), by_e += 2 * j * std::pow(e, j - 1);
        const Eigen::RowVector3d dt0(-t0 / (2 * g), 0, t0 / (2 * h)), unit_g(1, 0, 0), unit_e(0, 1, 0);
        const double u = t - t0 * sum, v = std::pow(e, k) * g * t0;
        const Eigen::RowVector3d du = -sum * dt0 - t0 * by_e * unit_e,
                                 dv = std::pow(e, k) * (t0 * unit_g + g * dt0) +
                                      k * std::pow(e, k - 1) * g * t0 * unit_e;
        Eigen::Matrix<double, 2, 3> S;
        S << u * dv + (v - g * u) * du - u * u / 2 * unit_g, dv - u * unit_g - g * du;
        return S;
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(height_of_a_ball_after_some_bounces) {
    const double g = 9.81, e = 0.8, h = 1.3;
    Eigen::Matrix<double, 2, 3> S0;
    S0 << 0, 0, 1, 0, 0, 0;
    const auto run = [&](double t1, double tol, const auto& bounce) {
        sc::sensitivity_options<Vector2d, Vector3d> s;
        s.S0 = &S0;
        return sc::sensitivities(radau, falls, Vector2d(h, 0), Vector3d(g, e, h), 0, t1, to(tol), s,
                                 sc::event(height, {.direction = sc::crossing::falling}, bounce));
    };
    const auto exact = [](const auto&, auto& y, const auto& p) { y[1] *= -p[1]; };
    const auto plain = [](double, Vector2d& y, const Vector3d& p) { y[1] *= -p[1]; };
    const double t0 = std::sqrt(2 * h / g);
    for (const double tol : tolerances)
        for (const int k : {1, 3, 9}) {
            const double before = t0 * (1 + 2 * (e - std::pow(e, k)) / (1 - e)),
                         t1 = before + t0 * std::pow(e, k) / 2;
            const MatrixXd S = bounces{k, g, e, h}.S(t1);
            const auto r = run(t1, tol, exact);
            BOOST_TEST(r.ok());
            BOOST_TEST_REQUIRE(static_cast<int>(r.events.size()) == k);
            BOOST_TEST(distance(r.S, S) < 1e-10);  // a parabola is solved to rounding
            BOOST_TEST(r.events[0].error == 0);
            BOOST_TEST(std::abs(r.events[0].dt[2] - t0 / (2 * h)) < 1e-12);
            const auto q = run(t1, tol, plain);
            BOOST_TEST(distance(q.S, S) < 1e-7);
            BOOST_TEST(q.events[0].error > 0);
            BOOST_TEST(distance(q.S, S) < 1e3 * q.events[0].error);
        }
}

BOOST_AUTO_TEST_CASE(a_ball_that_comes_to_rest_ends_the_run) {
    const auto r =
        sc::sensitivities_with_events(radau, falls, Vector2d(1, 0), Vector2d(9.81, 0.5), 0, 10,
                                      sc::event(height, {.direction = sc::crossing::falling},
                                                [](const auto&, auto& y, const auto& p) { y[1] *= -p[1]; }),
                                      to(1e-8));
    BOOST_TEST((r.status == sc::status::chattering));
    BOOST_TEST(std::abs(r.t - 3 * std::sqrt(2 / 9.81)) < 1e-6);
}

namespace {

// y' = -k y, the dose d (1 + y) at each time; p = (k, d). Both values where there are two.
struct schedule {
    double k, d;
    std::vector<double> times;
    struct value {
        double y, by_k, by_d;
    };
    value at(double t, bool behind) const {
        value x{1, 0, 0};
        double now = 0;
        const auto decay = [&](double until) {
            const double e = std::exp(-k * (until - now));
            x = {x.y * e, x.by_k * e - (until - now) * x.y * e, x.by_d * e};
            now = until;
        };
        for (const double dose : times) {
            if (dose > t || (dose == t && !behind)) break;
            decay(dose);
            x = {x.y + d * (1 + x.y), x.by_k * (1 + d), x.by_d * (1 + d) + 1 + x.y};
        }
        decay(t);
        return x;
    }
};
const auto decays = [](const auto&, const auto& y, const auto& p, auto& f) { f[0] = -p[0] * y[0]; };

}  // namespace

BOOST_AUTO_TEST_CASE(doses_that_depend_on_a_parameter) {
    using one = Eigen::Matrix<double, 1, 1>;
    const schedule truth{0.7, 0.3, {0, 1, 2.5, 4}};
    const Vector2d p(truth.k, truth.d);
    const auto dose = [](const auto&, auto& y, const auto& q) { y[0] += q[1] * (1 + y[0]); };
    const auto plain = [](double, one& y, const Vector2d& q) { y[0] += q[1] * (1 + y[0]); };
    sc::sensitivity_options<one, Vector2d> s;
    s.times = {0, 0, 0.5, 1, 2.5, 2.5, 2.5, 3, 4, 4};
    const std::vector<bool> behind{false, true, true, true, false, true, true, true, false, true};
    const auto check = [&](const auto& r, double most) {
        BOOST_TEST(r.ok());
        BOOST_TEST_REQUIRE(r.S_at.size() == s.times.size());
        for (std::size_t i = 0; i < s.times.size(); ++i) {
            const auto x = truth.at(s.times[i], behind[i]);
            const double here =
                s.times[i] == 0.5 || s.times[i] == 3 ? 10 * most : most;  // of the continuous solution
            BOOST_TEST(std::abs(r.y_at[i][0] - x.y) < here);
            BOOST_TEST(distance(r.S_at[i], Eigen::RowVector2d(x.by_k, x.by_d)) < here);
        }
        const auto end = truth.at(4, true);
        BOOST_TEST(distance(r.S, Eigen::RowVector2d(end.by_k, end.by_d)) < most);
        BOOST_TEST(r.events.size() == 4U);
        BOOST_TEST(r.events[1].t == 1);
        BOOST_TEST(r.events[1].dt.isZero(0));
    };
    for (const double tol : tolerances) {
        const one y0(1);
        check(
            sc::sensitivities_with_events(radau, decays, y0, p, 0, 4, sc::at(truth.times, dose), to(tol), s),
            30 * tol);
        check(
            sc::sensitivities_with_events(radau, decays, y0, p, 0, 4, sc::at(truth.times, plain), to(tol), s),
            30 * tol + 1e-9);
        check(sc::sensitivities(sc::gauss<3>(), decays, y0, p, 0, 4, to(tol), s, sc::at(truth.times, dose)),
              30 * tol);
        // In two lists, which act in turn.
        check(sc::sensitivities_with_events(radau, decays, y0, p, 0, 4,
                                            std::tuple(sc::at({1.0, 4.0}, dose), sc::at({0.0, 2.5}, dose)),
                                            to(tol), s),
              30 * tol);
    }
}

BOOST_AUTO_TEST_CASE(what_is_done_at_one_time_is_done_in_its_order) {
    using one = Eigen::Matrix<double, 1, 1>;
    const auto add = [](const auto&, auto& y, const auto& q) { y[0] += q[0]; };
    const auto square = [](const auto&, auto& y) { y[0] = y[0] * y[0]; };
    const auto rest = [](const auto&, const auto& y, const auto&, auto& f) { f[0] = 0 * y[0]; };
    const one y0(3), p(2);
    const auto first = sc::sensitivities_with_events(radau, rest, y0, p, 0, 2,
                                                     std::tuple(sc::at({1.0}, add), sc::at({1.0}, square)));
    const auto last = sc::sensitivities_with_events(radau, rest, y0, p, 0, 2,
                                                    std::tuple(sc::at({1.0}, square), sc::at({1.0}, add)));
    BOOST_TEST(std::abs(first.S(0, 0) - 2 * 5) < 1e-12);
    BOOST_TEST(std::abs(last.S(0, 0) - 1) < 1e-12);
}

BOOST_AUTO_TEST_CASE(break_points_leave_S_continuous) {
    using one = Eigen::Matrix<double, 1, 1>;
    // y' = a y before t = 1 and b y behind it; backwards too.
    const auto f = [](const auto& t, const auto& y, const auto& p, auto& out) {
        out[0] = (t < 1 ? p[0] : p[1]) * y[0];
    };
    for (const double tol : tolerances) {
        sc::options<double> o = to(tol);
        o.break_points = {1.0};
        const auto r = sc::sensitivities(radau, f, one(1), Vector2d(0.5, -1), 0, 3, o);
        const double y = std::exp(0.5 - 2);
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.S, Eigen::RowVector2d(y, 2 * y)) < 10 * tol);
        const auto b = sc::sensitivities(radau, f, one(1), Vector2d(0.5, -1), 3, 0, o);
        const double z = std::exp(2 - 0.5);
        BOOST_TEST(distance(b.S, Eigen::RowVector2d(-z, -2 * z)) < 100 * tol);
    }
}

namespace {

// y_1' = -a y_1, and -b y_1 from y_1 = s on; y_2' = y_1. What sets the side is held by reference.
struct two_fields {
    const bool* beyond;
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P& p, F& f) const {
        if (*beyond)
            f[0] = -p[1] * y[0];
        else
            f[0] = -p[0] * y[0];
        f[1] = y[0];
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_switch_between_two_linear_fields) {
    // p = (a, b, s): tau = ln(1/s)/a, y_1 = s exp(-b (t - tau)), y_2 = (1 - s)/a + (s - y_1)/b.
    const double a = 1.5, b = 0.4, s = 0.3, t1 = 2, tau = std::log(1 / s) / a,
                 y = s * std::exp(-b * (t1 - tau));
    const Eigen::RowVector3d dtau(-tau / a, 0, -1 / (a * s)), ds(0, 0, 1), da(1, 0, 0), db(0, 1, 0);
    const Eigen::RowVector3d dy = y / s * ds - y * (t1 - tau) * db + y * b * dtau;
    MatrixXd S(2, 3);
    S << dy, -ds / a - (1 - s) / (a * a) * da + (ds - dy) / b - (s - y) / (b * b) * db;
    const auto level = [](const auto&, const auto& x, const auto& p) { return x[0] - p[2]; };
    for (const double tol : tolerances) {
        bool beyond = false;
        const auto r = sc::sensitivities_with_events(
            radau, two_fields{&beyond}, Vector2d(1, 0), Vector3d(a, b, s), 0, t1,
            sc::event(level, {}, [&](const auto&, auto&) { beyond = true; }), to(tol));
        BOOST_TEST(r.ok());
        BOOST_TEST(r.events.size() == 1U);
        BOOST_TEST(distance(r.events[0].dt, dtau) < 30 * tol);
        BOOST_TEST(distance(r.S, S) < 100 * tol);
        // g of doubles: by differences.
        beyond = false;
        const auto q = sc::sensitivities_with_events(
            radau, two_fields{&beyond}, Vector2d(1, 0), Vector3d(a, b, s), 0, t1,
            sc::event([](double, const Vector2d& x, const Vector3d& p) { return x[0] - p[2]; }, {},
                      [&](double, Vector2d&) { beyond = true; }),
            to(tol));
        BOOST_TEST(distance(q.S, S) < 100 * tol + 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(a_relay_with_hysteresis) {
    // y' = k (u - y), u = U where it heats and 0 where not; on at `low`, off at `high`; p = (k, U, low, high). It heats for
    // A = ln((U - low)/(U - high))/k and cools for B = ln(high/low)/k, from low.
    const double k = 0.9, U = 2, low = 0.5, high = 1.2;
    const double A = std::log((U - low) / (U - high)) / k, B = std::log(high / low) / k,
                 t1 = 2 * (A + B) + A + B / 2;
    // In the third cooling: y = high exp(-k (t1 - 3A - 2B)).
    const double y = high * std::exp(-k * B / 2);
    const Eigen::RowVector4d dk(1, 0, 0, 0), dU(0, 1, 0, 0), dl(0, 0, 1, 0), dh(0, 0, 0, 1);
    const Eigen::RowVector4d dA = -A / k * dk + ((dU - dl) / (U - low) - (dU - dh) / (U - high)) / k,
                             dB = -B / k * dk + (dh / high - dl / low) / k;
    const Eigen::RowVector4d S = y / high * dh - y * B / 2 * dk + y * k * (3 * dA + 2 * dB);
    using one = Eigen::Matrix<double, 1, 1>;
    bool heats = true;
    const auto f = [&](const auto&, const auto& x, const auto& p, auto& out) {
        if (heats)
            out[0] = p[0] * (p[1] - x[0]);
        else
            out[0] = -p[0] * x[0];
    };
    Eigen::RowVector4d S0 = dl;
    const auto off =
        sc::event([](const auto&, const auto& x, const auto& p) { return x[0] - p[3]; },
                  {.direction = sc::crossing::rising}, [&](const auto&, auto&) { heats = false; });
    const auto on =
        sc::event([](const auto&, const auto& x, const auto& p) { return x[0] - p[2]; },
                  {.direction = sc::crossing::falling}, [&](const auto&, auto&) { heats = true; });
    for (const double tol : tolerances) {
        heats = true;
        sc::sensitivity_options<one, Vector4d> s;
        s.S0 = &S0;
        const auto r = sc::sensitivities_with_events(radau, f, one(low), Vector4d(k, U, low, high), 0, t1,
                                                     std::tuple(off, on), to(tol), s);
        BOOST_TEST(r.ok());
        BOOST_TEST(r.events.size() == 5U);
        BOOST_TEST(distance(r.S, S) < 300 * tol);
    }
}

BOOST_AUTO_TEST_CASE(what_is_done_depends_on_the_time_of_the_event) {
    // y_1 = t; at y_1 = a, y_2 goes to t b, whatever the action is a function of.
    const auto f = [](const auto&, const auto& y, const auto&, auto& out) { out << 1 + 0 * y[0], 0 * y[1]; };
    const auto g = [](const auto&, const auto& y, const auto& p) { return y[0] - p[0]; };
    const auto run = [&](const auto& action) {
        const auto r = sc::sensitivities_with_events(radau, f, Vector2d(0, 0), Vector2d(0.6, 3), 0, 1,
                                                     sc::event(g, {}, action));
        BOOST_TEST(r.ok());
        return MatrixXd(r.S);
    };
    const MatrixXd S = (MatrixXd(2, 2) << 0, 0, 3, 0.6).finished();
    BOOST_TEST(distance(run([](const auto& t, auto& y, const auto& p) { y[1] = t * p[1]; }), S) < 1e-12);
    BOOST_TEST(distance(run([](double t, auto& y, const auto& p) { y[1] = t * p[1]; }), S) < 1e-8);
    BOOST_TEST(distance(run([](double t, Vector2d& y, const Vector2d& p) { y[1] = t * p[1]; }), S) < 1e-8);
}

namespace {

// y' = -z, 0 = z - p_0 y, with both components in one vector; sin t keeps the algebraic equation moving.
struct algebraic {
    template <class T, class Y, class P, class F>
    void operator()(const T& t, const Y& y, const P& p, F& f) const {
        using std::sin;
        f[0] = -y[1] + sin(t);
        f[1] = y[1] - p[0] * y[0] - sin(t);
    }
    Eigen::Matrix2d mass() const { return Vector2d(1, 0).asDiagonal(); }
};

}  // namespace

BOOST_AUTO_TEST_CASE(algebraic_components_follow_behind_changes) {
    // y' = -k y, z = k y + sin t. A dose d at t = 0.25; at z = s, y is set to 1.
    const double k = 0.8, s = 1.33, d = 0.5, t1 = 0.8;
    const double start = std::exp(-k / 4) + d;
    // tau by bisection, where z rises.
    const auto z_of = [&](double K, double D, double t) {
        return K * (std::exp(-K / 4) + D) * std::exp(-K * (t - 0.25)) + std::sin(t);
    };
    double low = 0.26, up = 0.5;
    while (up - low > 1e-15) (z_of(k, d, (low + up) / 2) < s ? low : up) = (low + up) / 2;
    const double tau = (low + up) / 2, y = start * std::exp(-k * (tau - 0.25));
    // F(k, d, t) = k y + sin t - s = 0.
    const double by_t = -k * k * y + std::cos(tau), decay = std::exp(-k * (tau - 0.25));
    const double y_k = -tau * std::exp(-k * tau) - (tau - 0.25) * d * decay;
    const Eigen::RowVector3d dtau(-(y + k * y_k) / by_t, 1 / by_t, -k * decay / by_t);  // by k, s, d
    // y(t1) = exp(-k (t1 - tau)), z = k y + sin t.
    const double end = std::exp(-k * (t1 - tau));
    const Eigen::RowVector3d dk(1, 0, 0), dy = -end * (t1 - tau) * dk + end * k * dtau;
    MatrixXd S(2, 3);
    S << dy, end * dk + k * dy;
    const auto list =
        std::tuple(sc::at({0.25}, [](const auto&, auto& x, const auto& p) { x[0] += p[2]; }),
                   sc::event([](const auto&, const auto& x, const auto& p) { return x[1] - p[1]; },
                             {.direction = sc::crossing::rising}, [](const auto&, auto& x) { x[0] = 1; }));
    for (const double tol : tolerances) {
        const auto r = sc::sensitivities_with_events(radau, algebraic{}, Vector2d(1, k), Vector3d(k, s, d), 0,
                                                     t1, list, to(tol));
        BOOST_TEST(r.ok());
        BOOST_TEST_REQUIRE(r.events.size() == 2U);
        BOOST_TEST(std::abs(r.events[1].t - tau) < 100 * tol);
        BOOST_TEST(distance(r.events[1].dt, dtau) < 300 * tol);
        BOOST_TEST(distance(r.S, S) < 300 * tol);
    }
}

namespace {

struct masses {
    void operator()(const auto&, const auto& y, const auto& p, auto& f) const { f << p[0] * y[0], y[1]; }
    Eigen::Matrix2d mass() const { return (Eigen::Matrix2d() << 2, 1, 0, 1).finished(); }
};

}  // namespace

BOOST_AUTO_TEST_CASE(what_has_no_derivative_is_refused) {
    using one = Eigen::Matrix<double, 1, 1>;
    const auto runs = [](const auto& changes) {
        const auto f = [](const auto&, const auto& y, const auto&, auto& out) {
            out << 1 + 0 * y[0], 0 * y[1];
        };
        return sc::sensitivities_with_events(radau, f, Vector2d(0, 1), Vector2d(0.5, 0.5), 0, 1, changes);
    };
    const auto g = [](int k) {
        return sc::event([k](const auto&, const auto& y, const auto& p) { return y[0] - p[k]; }, {},
                         [k](const auto&, auto& y) { y[1] *= 2 + k; });
    };
    // Together for these p alone, and for all.
    BOOST_TEST(says(refusal(runs(std::tuple(g(0), g(1)))), "events 0 and 1 take place together"));
    const auto both = runs(std::tuple(g(0), g(0)));
    BOOST_TEST(both.ok());
    BOOST_TEST(both.y[1] == 4);
    BOOST_TEST(both.events.size() == 2U);
    // At the time of a dose.
    BOOST_TEST(says(refusal(runs(std::tuple(g(0), sc::at({0.5}, [](const auto&, auto& y) { y[0] += 1; })))),
                    "takes place together with an at()"));
    // Kinks of an action of doubles: its differences show it.
    BOOST_TEST(says(refusal(runs(sc::at({0.5}, [](double, Vector2d& y) { y[1] = std::abs(y[1] - 1); }))),
                    "has no derivative"));
    BOOST_TEST(runs(sc::at({0.5}, [](double, Vector2d& y) { y[1] = std::abs(y[1] + 1); })).ok());
    BOOST_TEST(
        says(refusal(runs(sc::at({0.5}, [](const auto&, auto& y) { y[1] /= 0.0; }))), "must leave y finite"));
    BOOST_TEST(says(message([&] {
                        runs(sc::event([](const auto&, const auto& y) { return y[0]; }, {.at_start = true}));
                    }),
                    ".at_start"));
    BOOST_TEST(says(message([&] { runs(sc::at({0.5, 2.0}, [](const auto&, auto&) {})); }), "at: times"));
    // y' of problems with another mass matrix is not at hand.
    const auto passes = sc::event([](const auto&, const auto& y) { return y[1] - 1.5; });
    const auto dose = sc::at({0.5}, [](const auto&, auto& y) { y[0] += 1; });
    BOOST_TEST(
        says(refusal(sc::sensitivities_with_events(radau, masses{}, Vector2d(1, 1), one(1), 0, 2, passes)),
             "not diagonal"));
    BOOST_TEST(sc::sensitivities_with_events(radau, masses{}, Vector2d(1, 1), one(1), 0, 1, dose).ok());
}
