// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE run_time_sizes
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/fully_implicit.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

#include "problems.hpp"

namespace sc = stagecraft;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Sizes known at run time: the same numbers, by automatic differentiation and by differences.
BOOST_AUTO_TEST_CASE(the_parts_of_a_semi_explicit_system_may_have_run_time_sizes) {
    const sc::options<double> tol{.rtol = 1e-8, .atol = 1e-8};
    auto fixed = sc::semi_explicit<2, 1>(dae::hlr_f{}, dae::hlr_g{});
    auto open = sc::semi_explicit(dae::hlr_f{}, dae::hlr_g{}, 2, 1);
    const auto a = sc::integrate(sc::radau_iia<3>(), fixed, Vector3d(1, 1, 1), 0, 1, tol);
    const auto b = sc::integrate(sc::radau_iia<3>(), open, Eigen::VectorXd(Vector3d(1, 1, 1)), 0, 1, tol);
    BOOST_TEST(b.ok());
    BOOST_TEST(a.report.steps == b.report.steps);
    BOOST_TEST((a.y - b.y).norm() < 1e-10);  // other eliminations: rounding, over h in z
    const auto c =
        sc::integrate(sc::radau_iia<3>(), sc::semi_explicit(dae::decay, dae::decay_constraint, 1, 1),
                      Eigen::VectorXd(Vector2d(1, -1)), 0, 1, tol);
    BOOST_TEST(c.ok());
    BOOST_TEST(c.y[0] == std::exp(-1.0), boost::test_tools::tolerance(1e-7));
    // A state of another size is refused.
    BOOST_CHECK_THROW(
        sc::integrate(sc::radau_iia<3>(), open, Eigen::VectorXd(Eigen::VectorXd::Ones(4)), 0, 1, tol),
        std::invalid_argument);
}

// n at run time and n fixed, systems of n unknowns in both: the same steps. A flag vector of a wrong
// size is refused.
BOOST_AUTO_TEST_CASE(an_implicit_system_may_have_a_run_time_size) {
    const sc::options<double> tol{.rtol = 1e-8, .atol = 1e-8};
    auto open = sc::fully_implicit(dae::cubic{}, 1);
    static_assert(sc::has_second_order_components<decltype(open)>);
    const auto a =
        sc::integrate(sc::radau_iia<3>(), sc::fully_implicit<1>(dae::cubic{}), Vector2d(0, 1), 0, 2, tol);
    const auto b = sc::integrate(sc::radau_iia<3>(), open, VectorXd(Vector2d(0, 1)), 0, 2, tol);
    BOOST_TEST(b.ok());
    BOOST_TEST(a.report.steps == b.report.steps);
    BOOST_TEST((a.y - b.y).norm() < 1e-12);
    BOOST_CHECK_THROW(sc::fully_implicit<1>(dae::cubic{}, 3), std::invalid_argument);
    BOOST_CHECK_THROW(sc::fully_implicit<1>(dae::cubic{}, std::vector<int>{1}), std::invalid_argument);
}
