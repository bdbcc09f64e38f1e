// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE fully_implicit
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/fully_implicit.hpp>

#include "problems.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;

namespace {

struct cubic_with_jacobian : dae::cubic {
    using one = Eigen::Matrix<double, 1, 1>;
    void jacobian(double, const one&, const one& v, one& F_y, one& F_v) const {
        F_y[0] = 1;
        F_v[0] = 1 + 3 * v[0] * v[0];
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(an_implicit_equation_with_regular_derivative_block_is_solved) {
    const sc::options<double> tol{.rtol = 1e-9, .atol = 1e-9};
    const auto problem = sc::fully_implicit<1>(dae::cubic{});
    const auto r = sc::integrate(sc::radau_iia<3>(), problem, Vector2d(0, 1), 0, 2, tol);
    BOOST_TEST(r.ok());
    BOOST_TEST(problem.value(r.y)[0] == std::sin(2.0), boost::test_tools::tolerance(1e-8));
    BOOST_TEST(problem.derivative(r.y)[0] == std::cos(2.0), boost::test_tools::tolerance(1e-7));
    const auto given = sc::integrate(sc::radau_iia<3>(), sc::fully_implicit<1>(cubic_with_jacobian{}),
                                     Vector2d(0, 1), 0, 2, tol);
    BOOST_TEST(given.report.steps == r.report.steps);
    BOOST_TEST(given.report.f_jacobian == 0);
    BOOST_TEST((given.y - r.y).norm() < 1e-12);
}

// Three stages and one stage, fixed steps: y has the classical order 2s - 1, and so has y' = v where F_v is
// regular, as both are values of one collocation polynomial at its last node.
BOOST_AUTO_TEST_CASE(both_y_and_its_derivative_have_the_classical_order) {
    const auto error = [](double h) {
        const auto r = sc::integrate(sc::radau_iia<2>(), sc::fully_implicit<1>(dae::cubic{}), Vector2d(0, 1),
                                     0, 1, {.rtol = 1e-13, .atol = 1e-13, .fixed_step = h});
        return Vector2d(std::abs(r.y[0] - std::sin(1.0)), std::abs(r.y[1] - std::cos(1.0)));
    };
    const Vector2d coarse = error(0.1), fine = error(0.05);
    for (int i = 0; i < 2; ++i)
        BOOST_TEST(std::log2(coarse[i] / fine[i]) == 3, boost::test_tools::tolerance(0.05));
}
