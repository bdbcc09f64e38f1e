// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE consistent
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <problems/equations.hpp>
#include <stagecraft/dae/consistent.hpp>
#include <stagecraft/problem/semi_explicit.hpp>
#include <stagecraft/problem/with.hpp>
#include <string>
#include <vector>

#include "problems.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::Vector3d;
using state = Eigen::Matrix<double, 5, 1>;

namespace {

const auto index_2 = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});

template <class F>
std::string error_of(F&& f) {
    try {
        f();
    } catch (const std::exception& e) {
        return e.what();
    }
    return "";
}
bool mentions(const std::string& text, const std::string& word) {
    return text.find(word) != std::string::npos;
}

}  // namespace

// g = y1^2 y2 - 1 and g_y f = 2 y1 y2 f1 + y1^2 f2 by hand at (1.1, 1, 1/2).
BOOST_AUTO_TEST_CASE(violations_are_reported_with_size_and_row) {
    const auto good = sc::check_consistent(index_2, 0, Vector3d(1, 1, 1));
    BOOST_TEST(good.constraints.size() == 2);
    BOOST_TEST(good.within(0));
    const auto c = sc::check_consistent(index_2, 0, Vector3d(1.1, 1, 0.5));
    BOOST_TEST(c.constraints[0].row == 2);
    BOOST_TEST(c.constraints[0].derivatives == 0);
    BOOST_TEST(c.constraints[0].value == 0.21, boost::test_tools::tolerance(1e-13));
    BOOST_TEST(c.constraints[1].row == 2);
    BOOST_TEST(c.constraints[1].derivatives == 1);
    const double f1 = 1.1 * 0.25, f2 = 1.21 - 1.5;
    BOOST_TEST(c.constraints[1].value == 2.2 * f1 + 1.21 * f2, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(c.largest() == c.constraints[1].value);
    BOOST_TEST(c.largest(0) == 0.21, boost::test_tools::tolerance(1e-13));
    BOOST_TEST(!c.within(0.25));
    BOOST_TEST(c.within(0.26));
    // A value that is not a number is not consistent.
    BOOST_TEST(!sc::check_consistent(index_2, 0, Vector3d(1, std::nan(""), 1)).within(1e300));
}

// Index 3: position, velocity and acceleration of the pendulum; Jay's problem at the exact solution.
BOOST_AUTO_TEST_CASE(index_3_problems_have_two_hidden_constraints) {
    state x;
    x << 0.9, 0.1, 0.05, -0.1, 3;
    const auto c = sc::check_consistent(dae::pendulum_3{}, 0, x);
    BOOST_TEST(c.constraints.size() == 3);
    const double q2 = 0.81 + 0.01;
    BOOST_TEST(c.constraints[0].value == (q2 - 1) / 2, boost::test_tools::tolerance(1e-13));
    BOOST_TEST(c.constraints[1].value == 0.9 * 0.05 - 0.1 * 0.1, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(c.constraints[2].value == 0.0025 + 0.01 - 0.1 - 3 * q2, boost::test_tools::tolerance(1e-10));
    BOOST_TEST(c.constraints[2].derivatives == 2);
    BOOST_TEST(c.singular == "");
    for (double t : {0.0, 0.3, 1.0}) {
        state y;
        y << std::exp(2 * t), std::exp(-t), std::exp(2 * t), std::exp(-t), std::exp(t);
        BOOST_TEST(sc::check_consistent(equations::index_three{}, t, y).within(1e-10));
        y[4] *= 1.001;
        BOOST_TEST(!sc::check_consistent(equations::index_three{}, t, y).within(1e-4));
    }
}

BOOST_AUTO_TEST_CASE(index_1_values_keep_the_differential_components) {
    const auto problem = sc::semi_explicit<4, 1>(dae::pendulum_f{}, dae::pendulum_acceleration{});
    state x;
    x << 0.6, -0.8, 0.4, 0.3, 100;
    const auto r = sc::consistent_initial_values(problem, 0, x);
    BOOST_TEST((r.y.head<4>() - x.head<4>()).norm() == 0);
    BOOST_TEST(r.y[4] == 0.25 + 0.8, boost::test_tools::tolerance(1e-14));  // v.v - y
    BOOST_TEST(r.check.within(1e-15));
    BOOST_TEST(r.change == 100 - 1.05, boost::test_tools::tolerance(1e-14));
}

// z from the hidden constraint, y by the smallest change: y - y0 is a multiple of the gradient at y. With
// free components given, those alone.
BOOST_AUTO_TEST_CASE(index_2_values_meet_the_constraint_and_the_hidden_one) {
    const auto r = sc::consistent_initial_values(index_2, 0, Vector3d(1.1, 1, 0.5));
    BOOST_TEST(r.check.within(1e-14));
    const Vector2d moved = r.y.head<2>() - Vector2d(1.1, 1), gradient(2 * r.y[0] * r.y[1], r.y[0] * r.y[0]);
    // Newton's corrections are least-norm each, their sum nearly so.
    BOOST_TEST(std::abs(moved[0] * gradient[1] - moved[1] * gradient[0]) <
               0.02 * moved.norm() * gradient.norm());
    const auto fixed_y1 = sc::consistent_initial_values(index_2, 0, Vector3d(1.1, 1, 0.5), {.free = {1, 2}});
    BOOST_TEST(fixed_y1.y[0] == 1.1);
    BOOST_TEST(fixed_y1.y[1] == 1 / 1.21, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(fixed_y1.check.within(1e-14));
    // Consistent values stay.
    BOOST_TEST(sc::consistent_initial_values(index_2, 0, Vector3d(1, 1, 1)).change == 0);
}

BOOST_AUTO_TEST_CASE(index_3_values_meet_all_three_constraints) {
    state x;
    x << 0.9, 0.1, 0.05, -0.1, 3;
    const auto r = sc::consistent_initial_values(dae::pendulum_3{}, 0, x);
    const Eigen::Vector2d q = r.y.head<2>(), v = r.y.segment<2>(2);
    BOOST_TEST(std::abs(q.norm() - 1) < 1e-15);
    BOOST_TEST(std::abs(q.dot(v)) < 1e-15);
    BOOST_TEST(std::abs(r.y[4] - (v.squaredNorm() - q[1])) < 1e-11);
    // From 2 per cent off the exact values of Jay's problem at t = 0.2, y1 and z1 kept.
    const double t = 0.2;
    state exact, start;
    exact << std::exp(2 * t), std::exp(-t), std::exp(2 * t), std::exp(-t), std::exp(t);
    start = exact;
    start[1] *= 1.02, start[3] *= 0.98, start[4] *= 1.02;
    const auto j = sc::consistent_initial_values(equations::index_three{}, t, start, {.free = {1, 3, 4}});
    BOOST_TEST((j.y - exact).norm() < 1e-9);
}

// 0 = y1 - sin(omega t): the hidden constraint z = omega cos(omega t) needs the derivative by time, automatic
// where the callable is generic and by differences where it is not.
BOOST_AUTO_TEST_CASE(hidden_constraints_take_the_explicit_time) {
    const double t = 0.7, omega = 3;
    const auto f = [](const auto&, const auto&, const auto& z, auto& out) {
        out[0] = z[0], out[1] = 2.0 * z[0];
    };
    const auto generic = [omega](const auto& time, const auto& y, auto& out) {
        using std::sin;
        out[0] = y[0] - sin(omega * time);
    };
    const auto plain = [omega](double time, const Vector2d& y, Eigen::Matrix<double, 1, 1>& out) {
        out[0] = y[0] - std::sin(omega * time);
    };
    const Vector3d start(0, 5, 0);
    const auto a = sc::consistent_initial_values(sc::semi_explicit<2, 1>(f, generic), t, start);
    const auto b = sc::consistent_initial_values(sc::semi_explicit<2, 1>(f, plain), t, start);
    const Vector3d exact(std::sin(omega * t), 5, omega * std::cos(omega * t));
    BOOST_TEST((a.y - exact).norm() < 1e-14);
    BOOST_TEST((b.y - exact).norm() < 1e-9);
}

BOOST_AUTO_TEST_CASE(singular_blocks_are_named) {
    // g = z^2 - y: g_z vanishes at z = 0.
    const auto f = [](const auto&, const auto&, const auto& z, auto& out) { out[0] = z[0]; };
    const auto g = [](const auto&, const auto& y, const auto& z, auto& out) { out[0] = z[0] * z[0] - y[0]; };
    const auto one = sc::semi_explicit<1, 1>(f, g);
    BOOST_TEST(mentions(error_of([&] { sc::consistent_initial_values(one, 0, Vector2d(1, 0)); }), "g_z"));
    BOOST_TEST(mentions(sc::check_consistent(one, 0, Vector2d(0, 0)).singular, "rank 0 of 1"));
    BOOST_TEST(sc::consistent_initial_values(one, 0, Vector2d(4, 1)).y[1] == 2);
    // g_y f_z = 2 y1 y2 (2 y1 y2^2 z) - 3 y1^2 y2^2 vanishes at (1, 1, 3/4).
    BOOST_TEST(mentions(error_of([] { sc::consistent_initial_values(index_2, 0, Vector3d(1, 1, 0.75)); }),
                        "g_y f_z"));
    // No real z solves z^2 = y < 0; z alone cannot satisfy g = 0 of index 2; a component that does not exist.
    BOOST_CHECK_THROW(sc::consistent_initial_values(one, 0, Vector2d(-1, 1)), std::exception);
    BOOST_TEST(mentions(
        error_of([] { sc::consistent_initial_values(index_2, 0, Vector3d(1.1, 1, 1), {.free = {2}}); }),
        "free components do not determine"));
    BOOST_CHECK_THROW(sc::consistent_initial_values(index_2, 0, Vector3d(1, 1, 1), {.free = {3}}),
                      std::invalid_argument);
    BOOST_CHECK_THROW(sc::consistent_initial_values(index_2, 0, Vector3d(1, 1, std::nan(""))),
                      std::invalid_argument);
    for (const double scale : {0.0, -1.0, std::nan("")})
        BOOST_TEST(mentions(error_of([&] {
                                sc::consistent_initial_values(index_2, 0, Vector3d(1, 1, 1),
                                                              {.time_scale = scale});
                            }),
                            "time_scale"));
}

// M with the coupled rows (-1, 2), (2, -4) and the row 3: the constraint is 2 f_1 + f_2.
BOOST_AUTO_TEST_CASE(constraints_of_a_mass_matrix_that_is_not_diagonal_are_combinations_of_rows) {
    struct coupled {
        void operator()(double, const Vector3d& x, Vector3d& f) const {
            f << x[0] - 1, x[1] * x[1] - 4, -x[2];
        }
        Eigen::Matrix3d mass() const {
            Eigen::Matrix3d m;
            m << -1, 2, 0, 2, -4, 0, 0, 0, 3;
            return m;
        }
    };
    const Vector3d x(1.5, 1, 7);
    const auto c = sc::check_consistent(coupled{}, 0, x);
    BOOST_TEST(c.constraints.size() == 1);
    BOOST_TEST(c.constraints[0].row == 0);
    BOOST_TEST(c.constraints[0].value == (2 * 0.5 - 3) / 2, boost::test_tools::tolerance(1e-12));
    const auto r = sc::consistent_initial_values(coupled{}, 0, x);
    BOOST_TEST(r.check.within(1e-13));
    BOOST_TEST((coupled{}.mass() * (r.y - x)).norm() < 1e-13);  // M x is kept
    BOOST_TEST(std::abs(2 * (r.y[0] - 1) + r.y[1] * r.y[1] - 4) < 1e-13);
}

BOOST_AUTO_TEST_CASE(an_ordinary_equation_has_no_constraints) {
    const auto f = [](double, const Vector2d& y, Vector2d& out) { out = -y; };
    const auto c = sc::check_consistent(f, 0, Vector2d(1, 2));
    BOOST_TEST(c.constraints.empty());
    BOOST_TEST(c.within(0));
    BOOST_TEST((sc::consistent_initial_values(f, 0, Vector2d(1, 2)).y - Vector2d(1, 2)).norm() == 0);
}

// Pendulums of all sizes and weights with positions and velocities off by 1e-4 ... 0.3 of the length, and no idea of the
// multiplier, with derivatives by differences and automatic ones. At the consistent state the multiplier is
// (m v^2 - m g y) / (2 l^2).
BOOST_AUTO_TEST_CASE(rough_pendulums_of_all_scales_become_consistent) {
    const auto values = [](auto&& pendulum, double m, double l, double g, const state& rough, int& refused) {
        try {
            const state x = sc::consistent_initial_values(pendulum, 0, rough).y;
            const double v2 = x[2] * x[2] + x[3] * x[3], multiplier = m * (v2 - g * x[1]) / (2 * l * l);
            BOOST_TEST(std::abs(x[0] * x[0] + x[1] * x[1] - l * l) < 1e-9 * l * l);
            BOOST_TEST(std::abs(x[0] * x[2] + x[1] * x[3]) < 1e-8 * l * (l + std::sqrt(v2)));
            BOOST_TEST(std::abs(x[4] - multiplier) < 1e-4 * (1 + std::abs(multiplier)));
        } catch (const std::runtime_error&) {
            ++refused;
        }
    };
    int refused = 0;
    for (int i = 0; i < 200; ++i) {
        const auto part = [i](double irrational) { return 2 * std::fmod((i + 1) * irrational, 1.0) - 1; };
        const double l = std::pow(10, part(std::sqrt(2))), m = std::pow(10, part(std::sqrt(3)));
        const double g = std::pow(10, 1 + part(std::sqrt(5))), angle = 3 * part(std::sqrt(7));
        const double w = 3 * part(std::sqrt(11)), off = l * std::pow(10, -2.25 + 1.75 * part(std::sqrt(13)));
        const double c = l * std::cos(angle), s = l * std::sin(angle);
        state rough;
        rough << s + off * part(std::sqrt(17)), -c - off * part(std::sqrt(19)),
            w * c + off * part(std::sqrt(23)), w * s - off * part(std::sqrt(29)), 0;
        const auto equations = [m, g, l](const auto& x, auto& f) {
            f[0] = x[2];
            f[1] = x[3];
            f[2] = -2.0 * x[0] * x[4];
            f[3] = -m * g - 2.0 * x[1] * x[4];
            f[4] = x[0] * x[0] + x[1] * x[1] - l * l;
        };
        const state weights = (state() << 1, 1, m, m, 0).finished();
        const auto flagged = [&](auto f) {
            return sc::with_index(sc::with_mass(f, Eigen::DiagonalMatrix<double, 5>(weights)),
                                  std::vector<int>{1, 1, 2, 2, 3});
        };
        values(flagged([&](double, const state& x, state& f) { equations(x, f); }), m, l, g, rough, refused);
        values(flagged([&](const auto&, const auto& x, auto& f) { equations(x, f); }), m, l, g, rough,
               refused);
    }
    BOOST_TEST(refused <= 1);
}
