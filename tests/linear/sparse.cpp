// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE sparse
#include <Eigen/SparseCore>
#include <array>
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

/// A chain of n unknowns with `diagonal` and 1/2 beside it, unknown k coupled with k + n/2 by `far`.
Eigen::SparseMatrix<double> chain(int n, double diagonal, double far) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i) {
        entries.emplace_back(i, i, diagonal);
        if (i > 0) entries.emplace_back(i, i - 1, 0.5), entries.emplace_back(i - 1, i, -0.5);
        if (i + n / 2 < n)
            entries.emplace_back(i, i + n / 2, far), entries.emplace_back(i + n / 2, i, 2 * far);
    }
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

// Few unknowns are eliminated with pivots on the diagonal, many by SparseLU, and so are few where the diagonal will not do;
// one after the other by the same solver, whose pattern stays.
BOOST_AUTO_TEST_CASE(few_and_many_unknowns_with_pivots_on_the_diagonal_and_beside_it_are_solved) {
    for (const int n : {6, 8, 100, 256, 258}) {
        const Eigen::VectorXd b = Eigen::VectorXd::Random(n), d = Eigen::VectorXd::Random(n);
        sc::sparse_blocks<double>::real real(n);
        sc::sparse_blocks<double>::complex block(n);
        for (const auto& [diagonal, far] : {std::array{-3.0, 0.1}, {1e-13, 7.0}, {0.0, 7.0}, {-5.0, 0.2}}) {
            const auto J = chain(n, diagonal, far);
            const double shift = diagonal < 0 ? 2 : 1e-14;
            BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, shift));
            Eigen::VectorXd x = b, y = d;
            real.solve(x.data());
            BOOST_TEST((shift * x - J * x - b).norm() < 1e-12);
            BOOST_REQUIRE(block.factor_shifted(sc::identity_mass{}, J, shift, -shift));
            x = b;
            block.solve(x.data(), y.data());
            BOOST_TEST((shift * x + shift * y - J * x - b).norm() < 1e-12);
            BOOST_TEST((shift * y - shift * x - J * y - d).norm() < 1e-12);
            BOOST_TEST(real.work().per_stage.iteration >
                       4 * n);  // the entries of the factors are known of either
        }
    }
}

BOOST_AUTO_TEST_CASE(a_singular_matrix_of_few_unknowns_with_pivots_beside_the_diagonal_is_refused) {
    auto J = chain(20, 0, 7);
    for (int j = 0; j < 20; ++j) J.coeffRef(3, j) = 0;
    sc::sparse_blocks<double>::real real(20);
    BOOST_TEST(!real.factor_shifted(sc::identity_mass{}, J, 0.0));
}
