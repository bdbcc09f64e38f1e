// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE dense
#include <Eigen/LU>
#include <array>
#include <boost/test/unit_test.hpp>
#include <complex>
#include <limits>
#include <random>
#include <stagecraft/linear/coupling.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/sparse_elimination.hpp>
#include <stagecraft/stages/sparse_pairs.hpp>

namespace sc = stagecraft;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
std::mt19937 generator(11);

/// Entries from the normal distribution, each with this probability, else zero.
MatrixXd random_matrix(int n, double density) {
    std::normal_distribution<double> entry;
    std::uniform_real_distribution<double> u(0, 1);
    return MatrixXd::NullaryExpr(n, n, [&] { return u(generator) < density ? entry(generator) : 0.0; });
}

/// |b - A x| / (|A| |x| + |b|) by components, computed with 64 bits of mantissa.
template <class Matrix, class Vector>
double backward_error(const Matrix& A, const Vector& x, const Vector& b) {
    using wide = std::conditional_t<std::is_same_v<typename Matrix::Scalar, double>, long double,
                                    std::complex<long double>>;
    const auto r = (b.template cast<wide>() - A.template cast<wide>() * x.template cast<wide>()).eval();
    const VectorXd size = A.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs();
    double largest = 0;
    for (int i = 0; i < b.size(); ++i)
        if (size[i] > 0) largest = std::max(largest, static_cast<double>(std::abs(r[i])) / size[i]);
    return largest;
}

double real_error(const MatrixXd& A) {
    const int n = static_cast<int>(A.rows());
    sc::dense_lu<double> lu(n);
    Eigen::Map<MatrixXd>(lu.entries(), n, n) = A;
    BOOST_REQUIRE(lu.factor());
    const VectorXd b = VectorXd::Random(n);
    VectorXd x = b;
    lu.solve(x.data());
    return backward_error(A, x, b);
}

double complex_error(const Eigen::MatrixXcd& A) {
    const int n = static_cast<int>(A.rows());
    sc::dense_complex_lu<double> lu(n);
    Eigen::Map<MatrixXd>(lu.real_entries(), n, n) = A.real();
    Eigen::Map<MatrixXd>(lu.imaginary_entries(), n, n) = A.imag();
    BOOST_REQUIRE(lu.factor());
    const Eigen::VectorXcd b = Eigen::VectorXcd::Random(n);
    VectorXd re = b.real(), im = b.imag();
    lu.solve(re.data(), im.data());
    const Eigen::VectorXcd x = re + std::complex<double>(0, 1) * im;
    return backward_error(A, x, b);
}

bool factors(const MatrixXd& re, const MatrixXd& im) {
    const int n = static_cast<int>(re.rows());
    sc::dense_complex_lu<double> lu(n);
    Eigen::Map<MatrixXd>(lu.real_entries(), n, n) = re;
    Eigen::Map<MatrixXd>(lu.imaginary_entries(), n, n) = im;
    return lu.factor();
}
bool factors(const MatrixXd& A) {
    const int n = static_cast<int>(A.rows());
    sc::dense_lu<double> lu(n);
    Eigen::Map<MatrixXd>(lu.entries(), n, n) = A;
    return lu.factor();
}

}  // namespace

// Every remainder of the blocks of four and eight columns, and of the packets.
BOOST_AUTO_TEST_CASE(solutions_are_backward_stable_at_every_size_around_the_blocks) {
    const std::complex<double> i(0, 1);
    for (const double density : {1.0, 0.15})
        for (const int n :
             {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 15, 16, 17, 23, 24, 25, 63, 64, 65, 129}) {
            const MatrixXd A = random_matrix(n, density) + MatrixXd::Identity(n, n);
            const MatrixXd B = random_matrix(n, density) + 2 * MatrixXd::Identity(n, n);
            BOOST_TEST_CONTEXT("n = " << n << ", density " << density) {
                BOOST_TEST(real_error(A) < 10 * n * eps);
                BOOST_TEST(complex_error(A + i * B) < 10 * n * eps);
            }
        }
}

BOOST_AUTO_TEST_CASE(rows_are_exchanged_where_the_diagonal_is_zero) {
    for (const int n : {5, 8, 19, 32}) {
        MatrixXd cycle = MatrixXd::Zero(n, n);  // a permutation matrix: the solution is exact
        for (int j = 0; j < n; ++j) cycle((j + 1) % n, j) = j % 2 == 0 ? 1 : -2;
        BOOST_TEST(real_error(cycle) == 0);
        BOOST_TEST(complex_error(std::complex<double>(0, 1) * cycle) == 0);
        MatrixXd hollow = random_matrix(n, 1);
        hollow.diagonal().setZero();
        BOOST_TEST(real_error(hollow) < 10 * n * eps);
        // Tiny diagonal: without exchanges every digit would be lost.
        hollow.diagonal().setConstant(1e-300);
        BOOST_TEST(complex_error(hollow.cast<std::complex<double>>()) < 10 * n * eps);
    }
}

BOOST_AUTO_TEST_CASE(singular_matrices_are_refused) {
    for (const int n : {1, 7, 8, 20, 33}) {
        BOOST_TEST(!factors(MatrixXd::Zero(n, n)));
        BOOST_TEST(!factors(MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)));
        MatrixXd A = MatrixXd::Identity(n, n);
        A.col(n / 2).setZero();
        BOOST_TEST(!factors(A));
        BOOST_TEST(!factors(A, A));
    }
}

// An entry that is not finite meets nothing but zero multipliers where the rest is diagonal.
BOOST_AUTO_TEST_CASE(no_skipped_zero_hides_an_entry_that_is_not_finite) {
    const int n = 19;
    const MatrixXd I = MatrixXd::Identity(n, n), Z = MatrixXd::Zero(n, n);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                MatrixXd A = I, B = Z;
                A(i, j) = B(i, j) = bad;
                BOOST_REQUIRE_MESSAGE(!factors(A), "real " << i << ' ' << j << ' ' << bad);
                BOOST_REQUIRE_MESSAGE(!factors(I, B), "imaginary " << i << ' ' << j << ' ' << bad);
            }
    BOOST_TEST(factors(I));
}

BOOST_AUTO_TEST_CASE(the_sign_of_the_determinant_is_known) {
    for (const int n : {1, 2, 8, 9, 21, 40})
        for (int k = 0; k < 10; ++k) {
            const MatrixXd A = random_matrix(n, 0.5) + MatrixXd::Identity(n, n);
            sc::dense_lu<double> lu(n);
            Eigen::Map<MatrixXd>(lu.entries(), n, n) = A;
            BOOST_REQUIRE(lu.factor());
            BOOST_TEST(lu.negative_determinant() == (Eigen::FullPivLU<MatrixXd>(A).determinant() < 0));
        }
}

namespace {

/// Mass action: every species decays into some others, so that each column is dominated by its diagonal.
MatrixXd kinetics_matrix(int n, int reactions) {
    std::uniform_int_distribution<int> species(0, n - 1);
    std::uniform_real_distribution<double> rate(0, 1);
    MatrixXd A = MatrixXd::Identity(n, n);
    for (int k = 0; k < reactions; ++k) {
        const int a = species(generator), b = species(generator);
        const double r = std::pow(10.0, 6 * rate(generator));
        A(a, a) += r;
        if (a != b) A(b, a) -= r;
    }
    return A;
}
bool leaves_out_zeros(MatrixXd A) {
    sc::sparse_elimination<sc::real_column<double>> lu;
    return lu.factor({A.data()}, static_cast<int>(A.rows()));
}

}  // namespace

BOOST_AUTO_TEST_CASE(few_entries_are_eliminated_without_the_zeros_and_as_exactly) {
    for (const int n : {8, 20, 63, 64, 65, 130})
        for (int k = 0; k < 5; ++k) {
            MatrixXd A = kinetics_matrix(n, n);
            BOOST_TEST_CONTEXT("n = " << n) {
                BOOST_TEST(leaves_out_zeros(A));
                BOOST_TEST(real_error(A) < 10 * n * eps);
                BOOST_TEST(complex_error(A + std::complex<double>(0, 3) * MatrixXd::Identity(n, n)) <
                           10 * n * eps);
                sc::dense_lu<double> lu(n);
                A.row(1) *= -1;
                Eigen::Map<MatrixXd>(lu.entries(), n, n) = A;
                BOOST_REQUIRE(lu.factor());
                BOOST_TEST(lu.negative_determinant());
                A.row(n - 1) *= 1e6;  // units do not matter: a temperature beside concentrations
                BOOST_TEST(leaves_out_zeros(A));
                BOOST_TEST(real_error(A) < 10 * n * eps);
            }
        }
    BOOST_TEST(!leaves_out_zeros(random_matrix(30, 1)));
    MatrixXd arrow = MatrixXd::Identity(12, 12);  // has no fill in one order, is full in the other
    arrow.row(0).setOnes();
    arrow.col(0).setOnes();
    arrow(0, 0) = 20;
    BOOST_TEST(leaves_out_zeros(arrow));
    BOOST_TEST(real_error(arrow) < 120 * eps);
    arrow(5, 5) = 1e-6;  // too small for a pivot: rows are exchanged
    BOOST_TEST(!leaves_out_zeros(arrow));
    BOOST_TEST(real_error(arrow) < 120 * eps);
}

BOOST_AUTO_TEST_CASE(systems_of_few_entries_are_solved_two_at_once) {
    const int n = 25;
    const MatrixXd J = -kinetics_matrix(n, 2 * n);
    const auto shifted = [&](std::complex<double> shift) {
        return Eigen::MatrixXcd(shift * Eigen::MatrixXcd::Identity(n, n) - J);
    };
    for (const int real : {0, 1})
        for (int complex = 1 - real; complex <= 4; ++complex) {
            sc::sparse_pairs<double> systems(real, complex);
            const VectorXd shift =
                VectorXd::Random(real + 2 * complex) + VectorXd::Constant(real + 2 * complex, 2);
            BOOST_REQUIRE(systems.factor(J, shift.data()));
            const MatrixXd b = MatrixXd::Random(n, shift.size());
            MatrixXd x = b, first = b;
            systems.solve(x.data());
            systems.solve_first(first.data(), real > 0 ? nullptr : first.data() + n);
            BOOST_TEST_CONTEXT(real << " real and " << complex << " complex systems") {
                if (real > 0) {
                    const MatrixXd A = shifted(shift[0]).real();
                    BOOST_TEST(backward_error(A, VectorXd(x.col(0)), VectorXd(b.col(0))) < 10 * n * eps);
                    BOOST_TEST(systems.negative_determinant() == (A.determinant() < 0));
                    BOOST_TEST((first.col(0) - x.col(0)).norm() <= 1e-14 * x.col(0).norm());
                } else {
                    BOOST_TEST((first.leftCols(2) - x.leftCols(2)).norm() <= 1e-14 * x.leftCols(2).norm());
                }
                for (int k = real; k < shift.size(); k += 2) {
                    const std::complex<double> i(0, 1);
                    const Eigen::VectorXcd z = x.col(k) + i * x.col(k + 1), r = b.col(k) + i * b.col(k + 1);
                    BOOST_TEST(backward_error(shifted({shift[k], shift[k + 1]}), z, r) < 10 * n * eps);
                }
            }
        }
    sc::sparse_pairs<double> systems(1, 1);
    const std::array<double, 3> shift{1, 1, 1};
    BOOST_TEST(!systems.factor(random_matrix(n, 1), shift.data()));
    BOOST_TEST(
        !systems.factor(MatrixXd(MatrixXd::Identity(n, n)), shift.data()));  // the real one is singular
    BOOST_TEST(!systems.factored());
    MatrixXd infinite = J;
    infinite(3, 3) = std::numeric_limits<double>::infinity();
    BOOST_TEST(!systems.factor(infinite, shift.data()));
}

BOOST_AUTO_TEST_CASE(factors_do_not_depend_on_what_was_factored_before) {
    const int n = 25;
    const MatrixXd A = kinetics_matrix(n, n), B = kinetics_matrix(n, 2 * n), C = random_matrix(n, 1);
    const VectorXd b = VectorXd::Random(n);
    const auto solve = [&](sc::dense_lu<double>& lu, const MatrixXd& matrix) {
        Eigen::Map<MatrixXd>(lu.entries(), n, n) = matrix;
        BOOST_REQUIRE(lu.factor());
        VectorXd x = b;
        lu.solve(x.data());
        return x;
    };
    sc::dense_lu<double> fresh(n), used(n);
    const VectorXd x = solve(fresh, A);
    for (const MatrixXd& before : {B, C, MatrixXd(B.transpose())}) {
        solve(used, before);
        BOOST_TEST((solve(used, A) == x));
    }
}

BOOST_AUTO_TEST_CASE(a_coupling_is_multiplied_with_and_without_zeros) {
    const int rows = 11, columns = 7;
    for (const double density : {0.0, 0.1, 0.7, 1.0}) {
        const MatrixXd J = random_matrix(20, density), C = J.block(9, 0, rows, columns);
        sc::coupling<double> coupling(rows, columns);
        for (int twice = 0; twice < 2; ++twice) coupling.take(J.data() + 9, 20);
        const VectorXd q = VectorXd::Random(columns), before = VectorXd::Random(rows);
        VectorXd r = before;
        coupling.add_product(q.data(), r.data());
        BOOST_TEST((r - (before + C * q)).norm() < 1e-14);
        MatrixXd entries = MatrixXd::Zero(rows, columns);
        coupling.each([&](int i, int j, double v) { entries(i, j) = v; });
        BOOST_TEST((entries == C));
    }
}

BOOST_AUTO_TEST_CASE(float_is_served_as_well) {
    const int n = 37;
    const Eigen::MatrixXf A = Eigen::MatrixXf::Random(n, n) + Eigen::MatrixXf::Identity(n, n);
    sc::dense_lu<float> lu(n);
    Eigen::Map<Eigen::MatrixXf>(lu.entries(), n, n) = A;
    BOOST_REQUIRE(lu.factor());
    const Eigen::VectorXf b = Eigen::VectorXf::Random(n);
    Eigen::VectorXf x = b;
    lu.solve(x.data());
    const double residual = (A.cast<double>() * x.cast<double>() - b.cast<double>()).norm();
    BOOST_TEST(residual < 1e-6 * n * A.norm() * x.norm());
}
