// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE suitesparse
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/sparse_once.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/klu.hpp>
#include <stagecraft/linear/umfpack.hpp>
#include <stagecraft/problem/with.hpp>
#include <type_traits>

#include <problems/stiff.hpp>

namespace sc = stagecraft;

namespace {

template <class Problem>
auto run(const Problem& p) {
    return sc::integrate(sc::radau_iia<3>(), p, p.initial(), p.t0, p.t1, {.rtol = 1e-7, .atol = 1e-7});
}

// Of the real and of the complex solver for shift M - J, relative to the right-hand side.
template <class Blocks>
double residual(const Eigen::SparseMatrix<double>& J) {
    const auto n = J.rows();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2), d = b.reverse();
    typename Blocks::real real(static_cast<int>(n));
    typename Blocks::complex complex(static_cast<int>(n));
    double worst = 0;
    for (const double shift : {5.0, 5e4}) {  // the second factorisation reuses the analysis of the first
        BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, shift));
        BOOST_REQUIRE(complex.factor_shifted(sc::identity_mass{}, J, shift, -2 * shift));
        Eigen::VectorXd x = b, re = b, im = d;
        real.solve(x.data());
        complex.solve(re.data(), im.data());
        worst = std::max({worst, (shift * x - J * x - b).norm(),
                          (shift * re + 2 * shift * im - J * re - b).norm(),
                          (shift * im - 2 * shift * re - J * im - d).norm()});
    }
    return worst / b.norm();
}

template <class Blocks>
bool factors(const Eigen::SparseMatrix<double>& J, double shift) {
    typename Blocks::real real(static_cast<int>(J.rows()));
    typename Blocks::complex complex(static_cast<int>(J.rows()));
    const bool one = real.factor_shifted(sc::identity_mass{}, J, shift),
               two = complex.factor_shifted(sc::identity_mass{}, J, shift, 0);
    BOOST_TEST(one == two);
    return one;
}

Eigen::SparseMatrix<double> brusselator_jacobian(int N) {
    const problems::sparse_brusselator p{{N}};
    Eigen::SparseMatrix<double> J = p.sparsity();
    p.jacobian(0, p.initial(), J);
    return J;
}

}  // namespace

BOOST_AUTO_TEST_CASE(real_and_complex_solutions_satisfy_their_equations) {
    const auto J = brusselator_jacobian(40);
    BOOST_TEST(residual<sc::klu_blocks>(J) < 1e-12);
    BOOST_TEST(residual<sc::umfpack_blocks>(J) < 1e-12);
}

BOOST_AUTO_TEST_CASE(singular_and_non_finite_matrices_are_refused) {
    Eigen::SparseMatrix<double> J(2, 2);
    J.insert(0, 0) = 1;
    J.insert(1, 1) = 2;
    for (const double shift : {1.0, 3.0}) {
        BOOST_TEST(factors<sc::klu_blocks>(J, shift) == (shift == 3));
        BOOST_TEST(factors<sc::umfpack_blocks>(J, shift) == (shift == 3));
    }
    J.coeffRef(0, 0) = std::nan("");
    BOOST_TEST(!factors<sc::klu_blocks>(J, 3));
    BOOST_TEST(!factors<sc::umfpack_blocks>(J, 3));
}

// shift - J is diagonal but for small entries at first; with the second shift its first diagonal entry is 1e-13, with
// the third one it is zero: the pivots of the first would leave three digits, and none.
BOOST_AUTO_TEST_CASE(pivots_that_no_longer_serve_are_chosen_anew) {
    Eigen::SparseMatrix<double> J(3, 3);
    J.insert(0, 0) = 2, J.insert(0, 1) = 1, J.insert(1, 0) = 1, J.insert(1, 1) = 1, J.insert(1, 2) = 1;
    J.insert(2, 1) = 1, J.insert(2, 2) = 5;
    using blocks = sc::klu_blocks;
    blocks::real real(3);
    blocks::complex complex(3);
    const Eigen::Vector3d b(1, 0.3, -0.7);
    for (const double shift : {1e3, 2 + 1e-13, 2.0, 1e3}) {
        BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, shift));
        BOOST_REQUIRE(complex.factor_shifted(sc::identity_mass{}, J, shift, 0.0));
        Eigen::Vector3d x = b, re = b, im = Eigen::Vector3d::Zero();
        real.solve(x.data());
        complex.solve(re.data(), im.data());
        BOOST_TEST((shift * x - J * x - b).norm() < 1e-14 * shift);
        BOOST_TEST((re - x).norm() < 1e-14);
        BOOST_TEST(im.norm() == 0);
    }
}

BOOST_AUTO_TEST_CASE(the_brusselator_is_the_same_with_klu_umfpack_and_sparse_lu) {
    const problems::sparse_brusselator p{{100}};
    const auto with_klu = sc::with_linear_solver<sc::klu_blocks>(p);
    const auto with_umfpack = sc::with_linear_solver<sc::umfpack_blocks>(p);
    using used = sc::system<const decltype(with_klu), Eigen::VectorXd>;
    static_assert(std::is_same_v<used::blocks, sc::klu_blocks>);
    static_assert(used::analytic);  // what else the problem brings is still seen
    const auto lu = run(p), klu = run(with_klu), umfpack = run(with_umfpack);
    BOOST_REQUIRE(lu.ok());
    BOOST_REQUIRE(klu.ok());
    BOOST_REQUIRE(umfpack.ok());
    BOOST_TEST(klu.report.steps == lu.report.steps);
    BOOST_TEST(umfpack.report.steps == lu.report.steps);
    BOOST_TEST((klu.y - lu.y).lpNorm<Eigen::Infinity>() < 1e-11);
    BOOST_TEST((umfpack.y - lu.y).lpNorm<Eigen::Infinity>() < 1e-11);
    BOOST_TEST((lu.y - p.initial()).lpNorm<Eigen::Infinity>() > 0.1);
}
