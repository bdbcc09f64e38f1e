// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE forward
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_ia.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/adjoint.hpp>
#include <stagecraft/sensitivity/forward.hpp>
#include <stdexcept>

namespace sc = stagecraft;
using Eigen::Vector2d, Eigen::Matrix2d;

namespace {

// One type, so that the steppers are compiled once: M y' = f with
// kind 0: a chain of decays, y_1 = a/(b-a) (e^{-at} - e^{-bt});
// kind 1: index 1, y' = -a z, 0 = z - b y, so that y = e^{-abt};
// kind 2: van der Pol's equation;
// kind 3: Prothero and Robinson's, y' = -100 (y - a cos t) + b;
// kind 4: index 2, y' = b z^3, 0 = y - e^{at};
// kind 5: index 1, y' = z - y, 0 = z^3 + z - a cos(bt), whose Jacobian changes much within a step.
struct example {
    int kind;
    template <class T, class Y, class P, class F>
    void operator()(const T& t, const Y& y, const P& p, F& f) const {
        using std::cos, std::exp;
        if (kind == 0) f << -p[0] * y[0], p[0] * y[0] - p[1] * y[1];
        if (kind == 1) f << -p[0] * y[1], y[1] - p[1] * y[0];
        if (kind == 2) f << y[1], p[0] * ((1 - y[0] * y[0]) * y[1] - p[1] * y[0]);
        if (kind == 3) f << -100 * (y[0] - p[0] * cos(t)) + p[1], y[0] - y[1];
        if (kind == 4) f << p[1] * y[1] * y[1] * y[1], y[0] - exp(p[0] * t);
        if (kind == 5) f << y[1] - y[0], y[1] * y[1] * y[1] + y[1] - p[0] * cos(p[1] * t);
    }
    Matrix2d mass() const { return Vector2d(1, kind == 1 || kind >= 4 ? 0 : 1).asDiagonal(); }
    std::array<int, 2> index() const { return {1, kind == 4 ? 2 : 1}; }
};

double distance(const Matrix2d& a, const Matrix2d& b) { return (a - b).cwiseAbs().maxCoeff(); }

}  // namespace

BOOST_AUTO_TEST_CASE(sensitivities_of_a_stiff_chain_follow_the_tolerance) {
    const double a = 2, b = 500, e = std::exp(-a), d = b - a;
    Matrix2d exact;
    exact << -e, 0, b / (d * d) * e - a / d * e, -a / (d * d) * e;
    for (const double tol : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
        const auto r = sc::sensitivities(sc::radau_iia<3>(), example{0}, Vector2d(1, 0), Vector2d(a, b), 0, 1,
                                         {.rtol = tol, .atol = tol});
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.S, exact) < 2 * tol);
    }
}

BOOST_AUTO_TEST_CASE(algebraic_components_need_no_consistent_initial_sensitivities) {
    const double a = 2, b = 0.75, y = std::exp(-a * b);
    Matrix2d exact;
    exact << -b * y, -a * y, -b * b * y, y - a * b * y;
    const Matrix2d S0 = (Matrix2d() << 0, 0, 7, -3).finished();
    for (const double tol : {1e-6, 1e-8, 1e-10}) {
        const auto r = sc::sensitivities(sc::radau_iia<3>(), example{1}, Vector2d(1, b), Vector2d(a, b), 0, 1,
                                         {.rtol = tol, .atol = tol}, &S0);
        BOOST_TEST(r.ok());
        BOOST_TEST(distance(r.S, exact) < tol);
    }
}

BOOST_AUTO_TEST_CASE(they_are_the_derivatives_of_the_numerical_solution) {
    const Vector2d y0(2, -0.6), p(20, 1.1);
    const sc::options<double> o{.rtol = 1e-12, .atol = 1e-12, .fixed_step = 0.02};
    const auto at = [&](const Vector2d& q) {
        const sc::at_parameters<example, Vector2d> problem({2}, q);
        return sc::integrate(sc::radau_iia<3>(), problem, y0, 0, 1, o).y;
    };
    const auto r = sc::sensitivities(sc::radau_iia<3>(), example{2}, y0, p, 0, 1, o);
    BOOST_TEST(r.ok());
    for (int k = 0; k < 2; ++k) {  // differences of order 6
        const Vector2d e = 0.0003 * p[k] * Vector2d::Unit(k);
        const Vector2d slope = (45 * (at(p + e) - at(p - e)) - 9 * (at(p + 2 * e) - at(p - 2 * e)) +
                                (at(p + 3 * e) - at(p - 3 * e))) /
                               (60 * e[k]);
        BOOST_TEST((r.S.col(k) - slope).norm() < 1e-9 * slope.norm());
    }
}

BOOST_AUTO_TEST_CASE(the_adjoint_gradient_is_that_of_the_sensitivities_to_rounding) {
    const auto g = [](const auto& y) { return y[0] * y[0] + y[0] * y[1]; };
    const auto compare = [&](const auto& method, int kind, const Vector2d& y0, const Vector2d& p,
                             double loose = 1e-4) {
        for (const double tol : {loose, 1e-9}) {
            const sc::options<double> o{.rtol = tol, .atol = tol};
            const auto forward =
                sc::sensitivities(method, example{kind}, y0, p, 0, 0.9, o, {.control = false});
            const auto back = sc::adjoint_gradient(method, example{kind}, y0, p, 0, 0.9, g, o);
            const auto &y = forward.y, slope = Vector2d(2 * y[0] + y[1], y[0]);
            const Vector2d expected = forward.S.transpose() * slope;
            BOOST_TEST((forward.ok() && back.ok()));
            BOOST_TEST((back.y == y));
            BOOST_TEST(back.value == g(y));
            BOOST_TEST((back.dp - expected).cwiseQuotient(expected).norm() < 1e-10);
        }
    };
    compare(sc::radau_iia<3>(), 2, Vector2d(2, -0.6), Vector2d(1000, 1.1));
    compare(sc::radau_iia<3>(), 1, Vector2d(1, 0.75), Vector2d(2, 0.75));
    compare(sc::gauss<3>(), 2, Vector2d(2, -0.6), Vector2d(20, 1.1));
    const Vector2d start(1, 1.0597675086);
    for (const double b : {2.8561, 3.7, 4.8, 6.3})
        compare(sc::radau_iia<5>(), 5, start, Vector2d(2.25, b), 1e-2);
    BOOST_CHECK_THROW(compare(sc::radau_ia<3>(), 2, Vector2d(2, -0.6), Vector2d(20, 1.1)),
                      std::invalid_argument);
    const auto r = sc::adjoint_gradient(sc::radau_iia<3>(), example{1}, Vector2d(1, 0.75), Vector2d(2, 0.75),
                                        0, 0.9, g, {.rtol = 1e-10, .atol = 1e-10});
    const double y = std::exp(-1.35);  // g = y^2 (1 + b)
    BOOST_TEST(std::abs(r.dp[0] + 2 * 0.9 * 0.75 * y * y * 1.75) < 1e-9);
    BOOST_TEST(std::abs(r.dp[1] - y * y + 2 * 0.9 * 2 * y * y * 1.75) < 1e-9);
    BOOST_TEST(std::abs(r.dy0[0] - 2 * y * y * 1.75) < 1e-9);
    BOOST_TEST(std::abs(r.dy0[1]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(the_adjoint_may_decay_to_the_smallest_numbers) {
    const auto g = [](const auto& y) { return y[0]; };
    const auto compare = [&](int kind, const Vector2d& y0, const Vector2d& p, double t1, double tol) {
        const sc::options<double> o{.rtol = tol, .atol = tol};
        const auto forward =
            sc::sensitivities(sc::radau_iia<3>(), example{kind}, y0, p, 0, t1, o, {.control = false});
        const auto back = sc::adjoint_gradient(sc::radau_iia<3>(), example{kind}, y0, p, 0, t1, g, o);
        BOOST_TEST((forward.ok() && back.ok()));
        BOOST_TEST((back.dp.transpose() - forward.S.row(0)).norm() < 1e-12 * forward.S.row(0).norm());
        BOOST_TEST(back.dy0.norm() < 1e-290);
    };
    const double a = 2, start = a * 1e4 / (1e4 + 1);
    compare(3, Vector2d(start, start), Vector2d(a, 0), 100, 1e-6);
    compare(3, Vector2d(start, start), Vector2d(a, 0), 10, 1e-9);
    compare(4, Vector2d(1, std::cbrt(0.5)), Vector2d(0.5, 1), 1, 1e-11);
}

namespace {
struct robertson {
    template <class T, class Y, class P, class F>
    void operator()(const T&, const Y& y, const P& p, F& f) const {
        f[0] = -p[0] * y[0] + p[1] * y[1] * y[2];
        f[2] = p[2] * y[1] * y[1];
        f[1] = -f[0] - f[2];
    }
};
}  // namespace

// At t = 4e10 steps h |f_y| of 1e15 leave rounding errors of 1e-8 in the stages of the derivatives, more than the smaller
// tolerances (below 8e-9 every run ended in newton_failed). For large t
// y_1 = (p_1/p_0)^2 / (p_2 t), by the two balances p_0 y_0 = p_1 y_1 y_2 and y_2' = p_2 y_1^2.
BOOST_AUTO_TEST_CASE(rounding_errors_of_long_stiff_steps_do_not_end_the_run) {
    const double t1 = 4e10;
    const Eigen::Vector3d p(0.04, 1e4, 3e7), y0(1, 0, 0);
    const double y = std::pow(p[1] / p[0], 2) / (p[2] * t1);
    for (const double tol : {1e-4, 1e-8, 3e-9, 1e-9}) {
        sc::options<double> o;
        o.rtol = tol;
        o.atol_components = Eigen::Vector3d(1e-8, 1e-14, 1e-6);
        const auto r = sc::sensitivities(sc::radau_iia<3>(), robertson(), y0, p, 0, t1, o);
        const auto first = [](const auto& end) { return end[0]; };
        const auto back = sc::adjoint_gradient(sc::radau_iia<3>(), robertson(), y0, p, 0, t1, first, o);
        BOOST_TEST(r.ok());
        BOOST_TEST(back.ok());
        const Eigen::RowVector3d exact(-2 * y / p[0], 2 * y / p[1], -y / p[2]);
        BOOST_TEST(((r.S.row(0) - exact).array() / exact.array()).abs().maxCoeff() < 1e-3);
        BOOST_TEST(((back.dp.transpose() - exact).array() / exact.array()).abs().maxCoeff() < 1e-3);
    }
}
