// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE automatic
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/equations.hpp>
#include <problems/stored.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/with.hpp>

namespace sc = stagecraft;

namespace {

// 20 components, more than one chunk of dual numbers: y_i' = y_{i+1} y_i - i y_i^2.
template <class Vector>
void chain(const Vector& y, Vector& f) {
    const int n = static_cast<int>(y.size());
    for (int i = 0; i < n; ++i) f[i] = y[(i + 1) % n] * y[i] - double(i) * y[i] * y[i];
}

Eigen::MatrixXd chain_jacobian(const Eigen::VectorXd& y) {
    const int n = static_cast<int>(y.size());
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
        J(i, i) += y[(i + 1) % n] - 2.0 * i * y[i];
        J(i, (i + 1) % n) += y[i];
    }
    return J;
}

template <class Problem>
Eigen::MatrixXd jacobian_of(Problem problem, const Eigen::VectorXd& y, sc::report<double>& report) {
    sc::system<Problem, Eigen::VectorXd> system(problem, y, report);
    Eigen::VectorXd f0(y.size());
    problem(0.0, y, f0);
    system.take_jacobian();
    system.evaluate_jacobian(0.0, y, f0, Eigen::VectorXd::Constant(y.size(), 1e-3));
    return system.jacobian();
}

}  // namespace

BOOST_AUTO_TEST_CASE(automatic_and_difference_jacobians_agree_with_the_analytic_one) {
    const Eigen::VectorXd y = Eigen::VectorXd::LinSpaced(20, 0.3, 1.7);
    const Eigen::MatrixXd exact = chain_jacobian(y);
    sc::report<double> by_duals, by_differences;
    const auto generic = [](const auto&, const auto& x, auto& f) { chain(x, f); };
    const auto plain = [](double, const Eigen::VectorXd& x, Eigen::VectorXd& f) { chain(x, f); };
    BOOST_TEST((jacobian_of(generic, y, by_duals) - exact).norm() < 1e-14 * exact.norm());
    BOOST_TEST(by_duals.f_jacobian == 3);  // ceil(20 / 8)
    const double distance = (jacobian_of(plain, y, by_differences) - exact).norm();
    BOOST_TEST(distance < 1e-6 * exact.norm());
    BOOST_TEST(distance > 1e-14 * exact.norm());  // these are differences
    BOOST_TEST(by_differences.f_jacobian == 20);
}

BOOST_AUTO_TEST_CASE(all_kinds_of_jacobian_lead_to_the_same_solution) {
    const Eigen::VectorXd ref = problems::reference("rober");
    const Eigen::Vector3d y0(1, 0, 0);
    const sc::options<double> o{.rtol = 1e-7, .atol = 1e-13};
    const auto differences = [](double t, const Eigen::Vector3d& y, Eigen::Vector3d& f) {
        equations::robertson{}(t, y, f);
    };
    const auto analytic =
        sc::with_jacobian(differences, [](double, const Eigen::Vector3d& y, Eigen::Matrix3d& J) {
            J << -0.04, 1e4 * y[2], 1e4 * y[1], 0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1], 0, 6e7 * y[1], 0;
        });
    const auto a = sc::integrate(sc::radau_iia<3>(), equations::robertson{}, y0, 0, 1e11, o);
    const auto b = sc::integrate(sc::radau_iia<3>(), analytic, y0, 0, 1e11, o);
    const auto c = sc::integrate(sc::radau_iia<3>(), differences, y0, 0, 1e11, o);
    BOOST_TEST(a.report.f_jacobian == a.report.jacobians);
    BOOST_TEST(b.report.f_jacobian == 0);
    BOOST_TEST(c.report.f_jacobian == 3 * c.report.jacobians);
    for (const auto& r : {a, b, c}) BOOST_TEST(problems::error(r.y, ref, 1e-6) < 1e-6);
    BOOST_TEST(a.report.steps == b.report.steps);
    BOOST_TEST((a.y - b.y).norm() < 1e-14);
}

// y' = 1 - 2 sqrt(y), y(0) = 0, a tank that fills: t = -s - log(1 - 2 s)/2 with s = sqrt(y). df/dy is infinite at t = 0.
BOOST_AUTO_TEST_CASE(a_run_may_start_where_a_generic_right_hand_side_has_an_infinite_derivative) {
    using one = Eigen::Matrix<double, 1, 1>;
    const auto tank = [](const auto&, const auto& y, auto& f) {
        using std::sqrt;
        f[0] = 1 - 2 * sqrt(y[0]);
    };
    for (const double tol : {1e-3, 1e-6, 1e-9}) {
        const auto r = sc::integrate(sc::radau_iia<3>(), tank, one(0), 0, 1, {.rtol = tol, .atol = tol});
        BOOST_TEST(r.ok());
        const double s = std::sqrt(r.y[0]), late = r.t + s + std::log(1 - 2 * s) / 2;
        BOOST_TEST(std::abs(late * (1 - 2 * s)) < 10 * tol);  // in y, with y' = 1 - 2 s
    }
}
