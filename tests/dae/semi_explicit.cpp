// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE semi_explicit
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/equations.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

#include "../message.hpp"
#include "problems.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::Vector3d;
using one = Eigen::Matrix<double, 1, 1>;
template <class S, int N>
using vec = Eigen::Matrix<S, N, 1>;

BOOST_AUTO_TEST_CASE(the_form_of_the_constraint_decides_the_index) {
    const auto two = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});
    BOOST_TEST((two.index() == std::vector<int>{1, 1, 2}));
    const auto one_ = sc::semi_explicit<4, 1>(dae::pendulum_f{}, dae::pendulum_acceleration{});
    BOOST_TEST((one_.index() == std::vector<int>{1, 1, 1, 1, 1}));
    BOOST_TEST(two.mass().diagonal().sum() == 2);
    BOOST_CHECK_THROW(sc::semi_explicit(dae::decay, dae::decay_constraint, -1, 1), std::invalid_argument);
}

// The same equations as a matrix problem: the same steps and, the operations being the same, the same result.
BOOST_AUTO_TEST_CASE(it_is_the_mass_matrix_problem_of_the_same_equations) {
    const auto a = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});
    const auto tol = sc::options<double>{.rtol = 1e-8, .atol = 1e-8};
    const auto x = sc::integrate(sc::radau_iia<3>(), a, Vector3d(1, 1, 1), 0, 1, tol);
    const auto y = sc::integrate(sc::radau_iia<3>(), equations::index_two{}, Vector3d(1, 1, 1), 0, 1, tol);
    BOOST_TEST(x.ok());
    BOOST_TEST(x.report.steps == y.report.steps);
    BOOST_TEST((x.y - y.y).norm() < 1e-13);
    BOOST_TEST(a.differential(x.y)[0] == std::exp(1.0), boost::test_tools::tolerance(1e-7));
    BOOST_TEST(a.algebraic(x.y)[0] == std::exp(2.0), boost::test_tools::tolerance(1e-5));
    BOOST_TEST(a.state(Vector2d(1, 2), one(3)) == Vector3d(1, 2, 3));
}

// HLR89: (2s - 1, s) for Radau IIA with three stages, (s + 1, s - 1) for Gauss.
BOOST_AUTO_TEST_CASE(index_2_orders_are_those_of_the_theory) {
    const auto problem = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});
    const auto error = [&](const auto& method, double h) {
        const auto r = sc::integrate(method, problem, Vector3d(1, 1, 1), 0, 0.4,
                                     {.rtol = 1e-14, .atol = 1e-14, .fixed_step = h});
        BOOST_TEST(r.ok());
        return Vector2d(std::abs(r.y[0] - std::exp(0.4)), std::abs(r.y[2] - std::exp(0.8)));
    };
    const auto slope = [&](const auto& method, double h, int i) {
        return std::log2(error(method, h)[i] / error(method, h / 2)[i]);
    };
    BOOST_TEST(slope(sc::radau_iia<3>(), 0.05, 0) == 5, boost::test_tools::tolerance(0.06));
    BOOST_TEST(slope(sc::radau_iia<3>(), 0.025, 1) == 3, boost::test_tools::tolerance(0.1));
    BOOST_TEST(slope(sc::gauss<3>(), 0.05, 0) == 4, boost::test_tools::tolerance(0.1));
    BOOST_TEST(slope(sc::gauss<3>(), 0.025, 1) == 2, boost::test_tools::tolerance(0.1));
    // These need equal steps, whose errors cancel (R(infinity) = -1): errors of z never decay.
    const auto free = [&] { sc::integrate(sc::gauss<3>(), problem, Vector3d(1, 1, 1), 0, 0.4); };
    BOOST_TEST(message(free).find("|R(infinity)| < 1 for problem.index() 2 and 3") != std::string::npos);
}

// t enters f and g: y' = z, 0 = z - y cos t has y = exp(sin t); with g alone moving, 0 = y1 - sin t, index 2.
BOOST_AUTO_TEST_CASE(right_hand_sides_and_constraints_may_depend_on_time) {
    const auto f = [](const auto&, const auto&, const auto& z, auto& out) { out = z; };
    const auto g = [](const auto& t, const auto& y, const auto& z, auto& out) {
        using std::cos;
        out[0] = z[0] - y[0] * cos(t);
    };
    const sc::options<double> tol{.rtol = 1e-10, .atol = 1e-10};
    const auto r =
        sc::integrate(sc::radau_iia<3>(), sc::semi_explicit<1, 1>(f, g), Vector2d(1, 1), 0, 2, tol);
    BOOST_TEST(r.ok());
    BOOST_TEST(r.y[0] == std::exp(std::sin(2.0)), boost::test_tools::tolerance(1e-8));
    BOOST_TEST(r.y[1] == std::exp(std::sin(2.0)) * std::cos(2.0), boost::test_tools::tolerance(1e-8));

    // A parameter by capture, and t in f: y1' = z, y2' = omega t z, 0 = y1 - sin(omega t).
    const double omega = 1.5;
    const auto f2 = [omega](double t, const vec<double, 2>&, const one& z, vec<double, 2>& out) {
        out << z[0], omega * t * z[0];
    };
    const auto g2 = [omega](double t, const vec<double, 2>& y, one& out) {
        out[0] = y[0] - std::sin(omega * t);
    };
    const auto s =
        sc::integrate(sc::radau_iia<3>(), sc::semi_explicit<2, 1>(f2, g2), Vector3d(0, 0, omega), 0, 2, tol);
    BOOST_TEST(s.ok());
    const double x = omega * 2;
    BOOST_TEST(s.y[0] == std::sin(x), boost::test_tools::tolerance(1e-8));
    BOOST_TEST(s.y[1] == x * std::sin(x) + std::cos(x) - 1, boost::test_tools::tolerance(1e-7));
    BOOST_TEST(s.y[2] == omega * std::cos(x), boost::test_tools::tolerance(1e-6));
}

namespace {

// With derivatives of its own: g exact, f automatic.
struct g_with_jacobian : dae::hlr_g {
    mutable int* calls;
    explicit g_with_jacobian(int* c) : calls(c) {}
    void jacobian(double, const Vector2d& y, Eigen::Matrix<double, 1, 2>& g_y) const {
        ++*calls;
        g_y << 2 * y[0] * y[1], y[0] * y[0];
    }
};
struct f_with_jacobian : dae::hlr_f {
    void jacobian(double, const Vector2d& y, const one& z, Eigen::Matrix2d& f_y, Vector2d& f_z) const {
        f_y << y[1] * y[1] * z[0] * z[0], 2 * y[0] * y[1] * z[0] * z[0], 2 * y[0] * y[1] * y[1],
            2 * y[0] * y[0] * y[1] - 6 * y[1] * z[0];
        f_z << 2 * y[0] * y[1] * y[1] * z[0], -3 * y[1] * y[1];
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(derivatives_given_by_blocks_agree_with_automatic_ones) {
    int calls = 0;
    const auto automatic = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});
    const Vector3d x(1.25, 0.75, 2.5);
    sc::automatic_jacobian<double, 3> engine(3);
    Eigen::Matrix3d expected, J;
    engine(automatic, 0.0, x, x, expected);
    sc::semi_explicit<2, 1>(dae::hlr_f{}, g_with_jacobian{&calls}).jacobian(0.0, x, J);
    BOOST_TEST((J - expected).norm() < 1e-13);
    sc::semi_explicit<2, 1>(f_with_jacobian{}, dae::hlr_g{}).jacobian(0.0, x, J);
    BOOST_TEST((J - expected).norm() < 1e-13);
    sc::semi_explicit<2, 1>(f_with_jacobian{}, g_with_jacobian{&calls}).jacobian(0.0, x, J);
    BOOST_TEST((J - expected).norm() < 1e-13);
    BOOST_TEST(calls == 2);
    const auto r =
        sc::integrate(sc::radau_iia<3>(), sc::semi_explicit<2, 1>(dae::hlr_f{}, g_with_jacobian{&calls}),
                      Vector3d(1, 1, 1), 0, 1, {.rtol = 1e-8, .atol = 1e-8});
    BOOST_TEST(r.ok());
    BOOST_TEST(calls == 2 + r.report.jacobians);
    BOOST_TEST(r.report.f_jacobian == 0);
}
