// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE sparse
#include <Eigen/SparseCore>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/sparse_once.hpp>
#include <random>
#include <stagecraft/linear/sparse_blocks.hpp>

namespace sc = stagecraft;

namespace {

Eigen::SparseMatrix<double> random_sparse(int n, std::mt19937& g) {
    std::uniform_real_distribution<double> u(-1, 1);
    std::uniform_int_distribution<int> at(0, n - 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < 4 * n; ++k) entries.emplace_back(at(g), at(g), u(g));
    Eigen::SparseMatrix<double> J(n, n);
    J.setFromTriplets(entries.begin(), entries.end());
    return J;
}

}  // namespace

BOOST_AUTO_TEST_CASE(sparse_real_and_complex_solutions_satisfy_their_equations) {
    std::mt19937 g(3);
    const int n = 60;
    const auto J = random_sparse(n, g);
    const Eigen::VectorXd b = Eigen::VectorXd::Random(n), d = Eigen::VectorXd::Random(n);

    sc::sparse_blocks<double>::real real(n);
    for (const double shift : {5.0, 50.0}) {  // the second factorisation reuses the analysis of the first
        BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, shift));
        Eigen::VectorXd x = b;
        real.solve(x.data());
        BOOST_TEST((shift * x - J * x - b).norm() < 1e-12);
    }
    sc::sparse_blocks<double>::complex block(n);
    BOOST_REQUIRE(block.factor_shifted(sc::identity_mass{}, J, 3.0, -4.0));
    Eigen::VectorXd x = b, y = d;
    block.solve(x.data(), y.data());
    BOOST_TEST((3 * x + 4 * y - J * x - b).norm() < 1e-12);
    BOOST_TEST((3 * y - 4 * x - J * y - d).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_singular_mass_matrix_is_served) {
    // M = diag(1, 0): shift M - J is regular as long as the algebraic part of J is.
    Eigen::SparseMatrix<double> J(2, 2);
    J.insert(0, 0) = -1;
    J.insert(0, 1) = 1;
    J.insert(1, 0) = 1;
    J.insert(1, 1) = 2;
    Eigen::Matrix2d M = Eigen::Vector2d(1, 0).asDiagonal();
    const sc::entry_mass<double> mass(M);
    sc::sparse_blocks<double>::real real(2);
    BOOST_REQUIRE(real.factor_shifted(mass, J, 10.0));
    Eigen::Vector2d x(1, 1);
    real.solve(x.data());
    BOOST_TEST((10 * M * x - J * x - Eigen::Vector2d(1, 1)).norm() < 1e-14);
}

BOOST_AUTO_TEST_CASE(singular_and_non_finite_matrices_are_refused) {
    Eigen::SparseMatrix<double> J(2, 2);
    J.insert(0, 0) = 1;
    J.insert(1, 1) = 1;
    sc::sparse_blocks<double>::real real(2);
    BOOST_TEST(!real.factor_shifted(sc::identity_mass{}, J, 1.0));
    J.coeffRef(0, 0) = std::nan("");
    BOOST_TEST(!real.factor_shifted(sc::identity_mass{}, J, 2.0));
    sc::sparse_blocks<double>::complex block(2);
    BOOST_TEST(!block.factor_shifted(sc::identity_mass{}, J, 2.0, 1.0));
}
