// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE banded
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <complex>
#include <random>
#include <stagecraft/linear/banded_blocks.hpp>
#include <vector>

namespace sc = stagecraft;

namespace {

sc::banded_matrix<double> random_band(int n, sc::bandwidth band, std::mt19937& g) {
    std::uniform_real_distribution<double> u(-1, 1);
    sc::banded_matrix<double> J(n, band);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            if (J.in_band(i, j)) J(i, j) = u(g);
    return J;
}

Eigen::MatrixXd dense(const sc::banded_matrix<double>& J) {
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(J.size(), J.size());
    for (int j = 0; j < J.size(); ++j)
        for (int i = 0; i < J.size(); ++i)
            if (J.in_band(i, j)) D(i, j) = J(i, j);
    return D;
}

const sc::bandwidth bands[] = {{0, 0}, {2, 2}, {1, 3}, {3, 1}, {0, 2}, {2, 0}, {6, 6}};

}  // namespace

BOOST_AUTO_TEST_CASE(banded_real_and_complex_solutions_agree_with_dense_lu) {
    std::mt19937 g(7);
    for (const sc::bandwidth band : bands) {
        const int n = 7;
        const auto J = random_band(n, band, g);
        const Eigen::MatrixXd D = dense(J);
        const Eigen::VectorXd b = Eigen::VectorXd::Random(n), d = Eigen::VectorXd::Random(n);

        sc::banded_blocks<double>::real real(n);
        BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, 3.5));
        Eigen::VectorXd x = b;
        real.solve(x.data());
        const Eigen::MatrixXd shifted = 3.5 * Eigen::MatrixXd::Identity(n, n) - D;
        BOOST_TEST((shifted * x - b).norm() < 1e-13);

        sc::banded_blocks<double>::complex block(n);
        BOOST_REQUIRE(block.factor_shifted(sc::identity_mass{}, J, 0.3, -0.7));
        Eigen::VectorXd re = b, im = d;
        block.solve(re.data(), im.data());
        const Eigen::MatrixXcd C = std::complex<double>(0.3, -0.7) * Eigen::MatrixXd::Identity(n, n) - D;
        const Eigen::VectorXcd z = re + std::complex<double>(0, 1) * im;
        const Eigen::VectorXcd rhs = b + std::complex<double>(0, 1) * d;
        BOOST_TEST((C * z - rhs).norm() < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(pivoting_reaches_the_widened_band) {
    // Zero diagonal: every step exchanges rows.
    sc::banded_matrix<double> J(5, {1, 1});
    for (int i = 0; i < 5; ++i) J(i, i) = 2;
    for (int i = 0; i + 1 < 5; ++i) J(i, i + 1) = -1 - i, J(i + 1, i) = -4 - i;
    sc::banded_blocks<double>::real real(5);
    BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, 3.0));
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(5, 1, 2);
    Eigen::VectorXd x = b;
    real.solve(x.data());
    BOOST_TEST(((3 * Eigen::MatrixXd::Identity(5, 5) - dense(J)) * x - b).norm() < 1e-13);
}

BOOST_AUTO_TEST_CASE(singular_and_non_finite_matrices_are_refused) {
    sc::banded_matrix<double> J(3, {1, 1});
    sc::banded_blocks<double>::real real(3);
    BOOST_TEST(!real.factor_shifted(sc::identity_mass{}, J, 0.0));
    J(1, 1) = std::nan("");
    BOOST_TEST(!real.factor_shifted(sc::identity_mass{}, J, 1.0));
    sc::banded_blocks<double>::complex block(3);
    BOOST_TEST(!block.factor_shifted(sc::identity_mass{}, J, 1.0, 1.0));
}

// In turn or one after the other: the same operations, the same numbers.
BOOST_AUTO_TEST_CASE(matrices_factored_in_turn_have_the_factors_that_each_has_alone) {
    using blocks = sc::banded_blocks<double>;
    std::mt19937 g(11);
    for (const sc::bandwidth band : bands) {
        const int n = 23;
        const auto J = random_band(n, band, g);
        const double shift[] = {0.4, 2.5, 0.3, -0.7, 1.5, 2.0};
        std::vector<blocks::real> reals(2, blocks::real(n));
        std::vector<blocks::complex> pairs(2, blocks::complex(n));
        for (int repeat = 0; repeat < 2; ++repeat) {  // with what the first run has left
            BOOST_REQUIRE(blocks::factor_all(reals, pairs, sc::identity_mass{}, J, shift));
            const Eigen::VectorXd b = Eigen::VectorXd::Random(n), d = Eigen::VectorXd::Random(n);
            for (int k = 0; k < 2; ++k) {
                blocks::real real(n);
                BOOST_REQUIRE(real.factor_shifted(sc::identity_mass{}, J, shift[k]));
                Eigen::VectorXd x = b, y = b;
                reals[k].solve(x.data()), real.solve(y.data());
                BOOST_TEST(x == y);
                blocks::complex pair(n);
                BOOST_REQUIRE(
                    pair.factor_shifted(sc::identity_mass{}, J, shift[2 + 2 * k], shift[3 + 2 * k]));
                Eigen::VectorXd re = b, im = d, u = b, v = d;
                pairs[k].solve(re.data(), im.data()), pair.solve(u.data(), v.data());
                BOOST_TEST((re == u && im == v));
            }
        }
    }
    sc::banded_matrix<double> zero(5, {1, 1});
    const double shift[] = {1, 0, 0};  // the second is singular
    std::vector<blocks::real> reals(1, blocks::real(5));
    std::vector<blocks::complex> pairs(1, blocks::complex(5));
    BOOST_TEST(!blocks::factor_all(reals, pairs, sc::identity_mass{}, zero, shift));
}

// The same of all right-hand sides of a step, of any number of stages; with a large shift no rows are exchanged.
BOOST_AUTO_TEST_CASE(systems_solved_in_turn_have_the_solutions_that_each_has_alone) {
    using blocks = sc::banded_blocks<double>;
    std::mt19937 g(13);
    const int n = 23;
    for (const sc::bandwidth band : {bands[0], bands[1], bands[2], bands[3], bands[6], {4, 4}})
        for (const double size : {0.5, 40.0})
            for (const auto& [number, of_pairs] :
                 {std::pair{1, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}, {1, 3}, {3, 1}}) {
                const auto J = random_band(n, band, g);
                std::vector<double> shift;
                for (int k = 0; k < number + 2 * of_pairs; ++k) shift.push_back(size + 0.1 * k);
                std::vector<blocks::real> reals(static_cast<std::size_t>(number), blocks::real(n));
                std::vector<blocks::complex> pairs(static_cast<std::size_t>(of_pairs), blocks::complex(n));
                BOOST_REQUIRE(blocks::factor_all(reals, pairs, sc::identity_mass{}, J, shift.data()));
                const Eigen::VectorXd b = Eigen::VectorXd::Random(n * (number + 2 * of_pairs));
                Eigen::VectorXd x = b, y = b;
                blocks::solve_all(reals, pairs, x.data(), n);
                double* at = y.data();
                for (const auto& block : reals) block.solve(at), at += n;
                for (const auto& block : pairs) block.solve(at, at + n), at += 2 * n;
                BOOST_TEST(x == y);
                BOOST_TEST(x != b);
            }
}

BOOST_AUTO_TEST_CASE(a_band_wider_than_the_matrix_is_an_error) {
    BOOST_CHECK_THROW(sc::banded_matrix<double>(3, {3, 0}), std::invalid_argument);
    BOOST_CHECK_THROW(sc::banded_matrix<double>(3, {0, -1}), std::invalid_argument);
}
