// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE finite_difference
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/jacobian/coloured.hpp>

namespace {

template <class S>
using vec3 = Eigen::Matrix<S, 3, 1>;

struct generic_robertson {
    template <class S>
    void operator()(const S&, const vec3<S>& y, vec3<S>& f) const {
        const S slow = 0.04 * y[0] - 1e4 * y[1] * y[2], fast = 3e7 * y[1] * y[1];
        f[0] = -slow;
        f[1] = slow - fast;
        f[2] = fast;
    }
};
// The same, callable with doubles only.
struct plain_robertson {
    void operator()(double t, const vec3<double>& y, vec3<double>& f) const { generic_robertson{}(t, y, f); }
};

template <class Problem>
auto run(const Problem& problem, double tol) {
    return stagecraft::integrate(stagecraft::radau_iia<3>(), problem, vec3<double>(1, 0, 0), 0.0, 40.0,
                                 {.rtol = tol, .atol = 1e-4 * tol});
}

}  // namespace

BOOST_AUTO_TEST_CASE(differences_serve_as_well_as_automatic_derivatives_on_a_badly_scaled_problem) {
    for (const double tol : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const auto exact = run(generic_robertson{}, tol), differences = run(plain_robertson{}, tol);
        BOOST_REQUIRE(exact.ok());
        BOOST_REQUIRE(differences.ok());
        BOOST_TEST((differences.y - exact.y).cwiseQuotient(exact.y).lpNorm<Eigen::Infinity>() < 10 * tol);
        BOOST_TEST(differences.report.steps < 1.3 * exact.report.steps + 5);
        BOOST_TEST(differences.report.rejected() < 10);
        BOOST_TEST(differences.report.f_jacobian == 3 * differences.report.jacobians);
    }
}

namespace {
const double not_there = std::numeric_limits<double>::quiet_NaN();
using one = Eigen::Matrix<double, 1, 1>;
using Eigen::VectorXd;
}  // namespace

BOOST_AUTO_TEST_CASE(a_column_that_leaves_the_domain_is_taken_on_the_other_side_and_then_with_less) {
    stagecraft::finite_difference_jacobian<double, 1> differences(1);
    one J;
    const auto column = [&](const auto& f, double y, double f0, double negligible) {
        return differences(f, 0.0, one(y), one(f0), one(negligible), 0.0, J);
    };
    const auto decay = [](double, const one& y, one& f) { f[0] = -3 * y[0] + 0 * std::sqrt(y[0]); };
    BOOST_TEST(column(decay, 1e-20, -3e-20, 1e-6) == 2);  // downwards by 1e-14 is beyond zero
    BOOST_TEST(std::abs(J(0, 0) + 3) < 1e-6);
    const auto narrow = [](double, const one& y, one& f) {
        f[0] = std::abs(y[0] - 1) < 1e-9 ? 2 * (y[0] - 1) : not_there;
    };
    BOOST_TEST(column(narrow, 1, 0, 0) == 3);
    BOOST_TEST(std::abs(J(0, 0) - 2) < 1e-4);
    const auto nowhere = [](double, const one&, one& f) { f[0] = not_there; };
    BOOST_TEST(column(nowhere, 1, 0, 0) == 4);
    BOOST_TEST(std::isnan(J(0, 0)));
}

BOOST_AUTO_TEST_CASE(columns_that_are_taken_together_may_leave_the_domain_on_different_sides) {
    stagecraft::coloured_jacobian<VectorXd> differences(2);
    stagecraft::banded_matrix<double> J(2, {0, 0});
    differences.group(J);
    BOOST_TEST(differences.groups() == 1);
    const auto within = [](double, const VectorXd& y, VectorXd& f) {  // 0 <= y_0, y_1 <= 1
        f = -2 * y;
        if (y[0] < 0 || y[1] > 1) f.setConstant(not_there);
    };
    const VectorXd y{{0, 1}}, small{{1e-3, 1e-3}};
    BOOST_TEST(differences(within, 0.0, y, VectorXd{{-1e-300, -2}}, small, 0.0, J) == 4 + 2 + 1);
    BOOST_TEST(std::abs(J(0, 0) + 2) < 1e-6);
    BOOST_TEST(std::abs(J(1, 1) + 2) < 1e-6);
    // Both on the other side, at once.
    BOOST_TEST(differences(within, 0.0, y, VectorXd{{-1e-300, 0}}, small, 0.0, J) == 2);
}

BOOST_AUTO_TEST_CASE(a_positive_state_decays_below_the_increments_of_differences) {
    const double k = 1e6;
    const auto half = [&](double, const one& y, one& f) { f[0] = -k * y[0] * std::sqrt(y[0]); };
    for (const double tol : {1e-3, 1e-6, 1e-9}) {  // y = (1 + k t / 2)^-2
        const auto r = stagecraft::integrate(stagecraft::radau_iia<3>(), half, one(1.0), 0.0, 1e3,
                                             {.rtol = tol, .atol = tol});
        BOOST_TEST(name(r.status) == "success");
        BOOST_TEST(std::abs(r.y[0] - std::pow(1 + k * 1e3 / 2, -2)) < tol);
    }
}
