// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE presb
#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/families.hpp>

// The preconditioner of pairs that linear/petsc.hpp uses, with exact inverses: for symmetric positive definite M and
// negative semidefinite J the eigenvalues of the preconditioned system lie in [1/2, 1] (Axelsson-Neytcheva).
using Eigen::MatrixXd;

namespace {

MatrixXd random(int n, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> number;
    return MatrixXd::NullaryExpr(n, n, [&] { return number(generator); });
}

struct range {
    double least, most, imaginary;
};

// With A = alpha M - J, B = beta M: P^-1 K column by column, by h := (A+B)^-1 (r1 + r2), y := (A+B)^-1 (r2 - B h),
// x := h - y.
range eigenvalues(const MatrixXd& M, const MatrixXd& J, double alpha, double beta) {
    const Eigen::Index n = M.rows();
    const MatrixXd A = alpha * M - J, B = beta * M;
    MatrixXd K(2 * n, 2 * n);
    K << A, -B, B, A;
    const Eigen::PartialPivLU<MatrixXd> sum(A + B);
    const MatrixXd h = sum.solve(K.topRows(n) + K.bottomRows(n)), y = sum.solve(K.bottomRows(n) - B * h);
    MatrixXd preconditioned(2 * n, 2 * n);
    preconditioned << h - y, y;
    const Eigen::VectorXcd lambda = Eigen::EigenSolver<MatrixXd>(preconditioned, false).eigenvalues();
    return {lambda.real().minCoeff(), lambda.real().maxCoeff(), lambda.imag().cwiseAbs().maxCoeff()};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_eigenvalues_of_every_pair_lie_between_one_half_and_one) {
    const int n = 10;
    const MatrixXd X = random(n, 1), identity = MatrixXd::Identity(n, n);
    const MatrixXd M = X * X.transpose() + 0.1 * identity;
    MatrixXd Z = random(n, 3);
    Z.rightCols(4).setZero();
    const MatrixXd J = -Z * Z.transpose();  // singular
    double least = 1, most = 0;
    for (int s = 2; s <= 9; ++s) {
        const auto method = stagecraft::radau_iia(s);
        for (int k = 0; k < method.alpha.size(); ++k)
            for (const double h : {1e-6, 1e-3, 1.0, 1e3})
                for (const MatrixXd& mass : {identity, M}) {
                    const range r = eigenvalues(mass, J, method.alpha[k] / h, method.beta[k] / h);
                    // Double eigenvalues: half of the digits.
                    BOOST_TEST(r.least >= 0.5 - 1e-6);
                    BOOST_TEST(r.most <= 1 + 1e-6);
                    BOOST_TEST(r.imaginary <= 1e-6);
                    least = std::min(least, r.least);
                    most = std::max(most, r.most);
                }
    }
    BOOST_TEST(least < 0.6);  // the bound is nearly reached
    BOOST_TEST(most > 0.999);
}

// M = diag(1, 0), as for incompressible flow: on what satisfies the constraint the bound is that of -K, and the
// infinite eigenvalues of the pencil, in blocks of two, become 1.
BOOST_AUTO_TEST_CASE(in_a_saddle_point_problem_of_index_2_they_do_as_well) {
    const int n = 8, m = 3;
    const MatrixXd Z = random(n, 5).leftCols(5), G = random(n, 6).leftCols(m);
    MatrixXd M = MatrixXd::Zero(n + m, n + m), J = M;
    M.topLeftCorner(n, n).setIdentity();
    J.topLeftCorner(n, n) = -Z * Z.transpose();
    J.topRightCorner(n, m) = -G;
    J.bottomLeftCorner(m, n) = G.transpose();
    double least = 1;
    for (int s = 2; s <= 9; ++s) {
        const auto method = stagecraft::radau_iia(s);
        for (int k = 0; k < method.alpha.size(); ++k)
            for (const double h : {1e-2, 1.0, 1e2}) {
                const range r = eigenvalues(M, J, method.alpha[k] / h, method.beta[k] / h);
                // Blocks of two at 1, double eigenvalues below: half of the digits, less what h takes.
                BOOST_TEST(r.least >= 0.5 - 1e-5);
                BOOST_TEST(r.most <= 1 + 1e-5);
                BOOST_TEST(r.imaginary <= 1e-5);
                least = std::min(least, r.least);
            }
    }
    BOOST_TEST(least < 0.6);
}

BOOST_AUTO_TEST_CASE(without_definiteness_the_bound_does_not_hold) {
    const MatrixXd identity = MatrixXd::Identity(4, 4);
    const range r = eigenvalues(identity, 5 * identity, 4, 3);
    BOOST_TEST(r.most > 2);
}
