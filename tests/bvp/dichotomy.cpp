// SPDX-License-Identifier: BSL-1.0
// Lecture, section 4.2: solutions that do not grow and solutions that do not fall.
#define BOOST_TEST_MODULE bvp_dichotomy
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/theory/dynamics/green_function.hpp>
#include <string>

#include "../message.hpp"

using namespace stagecraft;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using problem = theory::linear_two_point<double>;

namespace {

MatrixXd random_matrix(std::mt19937& generator, Eigen::Index rows, Eigen::Index columns) {
    std::normal_distribution<double> number;
    MatrixXd a(rows, columns);
    for (Eigen::Index k = 0; k < a.size(); ++k) a.data()[k] = number(generator);
    return a;
}

MatrixXd diagonal(const VectorXd& d) { return d.asDiagonal(); }

/// x' = V diag(rates) V^-1 x on [0, T] with B0 x(0) + BT x(T) = d.
problem modes(const MatrixXd& V, const VectorXd& rates, double T, const MatrixXd& B0, const MatrixXd& BT) {
    const MatrixXd Vi = V.inverse();
    return {[=](double t) { return MatrixXd(V * diagonal((t * rates).array().exp().matrix()) * Vi); }, 0, T,
            B0, BT};
}

/// x' = A(t) x with X(t) = R(t) diag(e^{-18 t}, e^{20 t}), R(t) a rotation (Ascher, Mattheij, Russell, p. 151).
problem turning(double T) {
    return {[](double t) {
                const MatrixXd R =
                    (MatrixXd(2, 2) << std::cos(t), std::sin(t), -std::sin(t), std::cos(t)).finished();
                return MatrixXd(R * diagonal(Eigen::Vector2d(std::exp(-18 * t), std::exp(20 * t))));
            },
            0, T, MatrixXd::Identity(2, 2), MatrixXd::Identity(2, 2)};
}

const MatrixXd one = MatrixXd::Identity(2, 2), first = diagonal(Eigen::Vector2d(1, 0)), nothing = 0 * one;

/// By how much solutions from bases of the spaces at s exceed the two estimates, over 9 x 9 times; at most 1 where they hold.
double excess(const problem& p, const MatrixXd& P, double alpha, double beta, double K) {
    double most = 0;
    for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= i; ++j) {
            const double t = p.at(i, 8), s = p.at(j, 8);
            const MatrixXd step = p.X(t) * p.inverse(p.X(s));
            const auto [falling, growing] = theory::dichotomy_spaces(p, P, s);
            for (double angle = 0; angle < 3.1; angle += 0.3) {  // combinations, where there are two columns
                const auto pick = [&](const MatrixXd& basis) {
                    return VectorXd(std::cos(angle) * basis.col(0) +
                                    std::sin(angle) * basis.col(basis.cols() - 1));
                };
                const VectorXd x = pick(falling), y = pick(growing);
                most = std::max(most, (step * x).norm() / (K * std::exp(-alpha * (t - s)) * x.norm()));
                most = std::max(most, std::exp(beta * (t - s)) * y.norm() / (K * (step * y).norm()));
            }
        }
    return most;
}

}  // namespace

BOOST_AUTO_TEST_CASE(s_minus_and_s_plus_are_complements_and_hold_what_does_not_grow_and_does_not_fall) {
    std::mt19937 generator(45);
    for (int k = 0; k < 40; ++k) {
        const MatrixXd V = random_matrix(generator, 3, 3);
        const problem p =
            modes(V, Eigen::Vector3d(-2, -1, 3), 2, MatrixXd::Identity(3, 3), MatrixXd::Zero(3, 3));
        const MatrixXd P = V * diagonal(Eigen::Vector3d(1, 1, 0)) * V.inverse();
        const double K = theory::dichotomy_constant<double>(p, P, 1, 3, 8);
        BOOST_TEST(excess(p, P, 1, 3, K) <= 1 + 1e-6);
        for (const double t : {0.0, 0.7, 2.0}) {
            const auto [minus, plus] = theory::dichotomy_spaces(p, P, t);
            BOOST_TEST((minus.cols() == 2 && plus.cols() == 1));
            MatrixXd both(3, 3);
            both << minus, plus;
            BOOST_TEST(std::abs(both.determinant()) > 1e-6);  // direct: together a basis
            // constant coefficients: the spaces are those of the eigenvectors, at all times
            const auto in = [](const MatrixXd& basis, const VectorXd& v) {
                return (v - basis * (basis.transpose() * v)).norm() / v.norm();
            };
            BOOST_TEST(in(minus, V.col(0)) < 1e-7);
            BOOST_TEST(in(minus, V.col(1)) < 1e-7);
            BOOST_TEST(in(plus, V.col(2)) < 1e-7);
        }
        // A projector on other spaces: no constant of this size, and the estimates of S- fail with the first K.
        const MatrixXd W = random_matrix(generator, 3, 3),
                       Q = W * diagonal(Eigen::Vector3d(1, 1, 0)) * W.inverse();
        BOOST_TEST(theory::dichotomy_constant<double>(p, Q, 1, 3, 8) > 2 * K);
        BOOST_TEST(excess(p, Q, 1, 3, K) > 1);
        BOOST_TEST(
            message([&] { theory::dichotomy_spaces(p, 2 * P, 0); }).starts_with("P: must be a projector"));
    }
    // Spaces that turn with t: S-(t) = span R(t) e_1, S+(t) = span R(t) e_2.
    const problem p = turning(0.5);
    BOOST_TEST(std::abs(theory::dichotomy_constant<double>(p, first, 18, 20, 20) - 1) < 1e-9);
    BOOST_TEST(excess(p, first, 18, 20, 1) <= 1 + 1e-6);
    for (const double t : {0.0, 0.2, 0.5}) {
        const auto [minus, plus] = theory::dichotomy_spaces(p, first, t);
        BOOST_TEST(std::abs(std::abs(minus.col(0).dot(Eigen::Vector2d(std::cos(t), -std::sin(t)))) - 1) <
                   1e-12);
        BOOST_TEST(std::abs(std::abs(plus.col(0).dot(Eigen::Vector2d(std::sin(t), std::cos(t)))) - 1) <
                   1e-12);
    }
    // P = 1: all solutions are in S-, none in S+
    const auto all = theory::dichotomy_spaces(p, one, 0.3);
    BOOST_TEST((all.minus.cols() == 2 && all.plus.cols() == 0));
}

BOOST_AUTO_TEST_CASE(
    the_turning_point_printed_as_not_dichotomic_is_exponentially_dichotomic_for_every_alpha) {
    // x1' = -2t/eps x1, x2' = x2 on [-1, oo), P = diag(1, 0), beta = 1: t^2 - s^2 + eps alpha (s - t) is least at s = -1,
    // t = alpha eps/2, so K = e^{(1 + alpha eps/2)^2/eps}; the lecture holds that no alpha can be reached.
    for (const double eps : {1.0, 0.5})
        for (const double alpha : {0.0, 1.0, 3.0}) {
            const problem p{
                [eps](double t) {
                    return diagonal(Eigen::Vector2d(std::exp((1 - t * t) / eps), std::exp(t + 1)));
                },
                -1, 4, one, nothing};
            const double K = theory::dichotomy_constant<double>(p, first, alpha, 1, 100),
                         exact = std::exp(std::pow(1 + alpha * eps / 2, 2) / eps);
            BOOST_TEST(K == exact, boost::test_tools::tolerance(1e-9));
            // and from s = 0 on, without the turning point, K = e^{alpha^2 eps/4}
            const problem right{p.X, 0, 4, one, nothing};
            BOOST_TEST(theory::dichotomy_constant<double>(right, first, alpha, 1, 80) ==
                           std::exp(alpha * alpha * eps / 4),
                       boost::test_tools::tolerance(1e-9));
        }
    // Not dichotomic, not even with alpha = beta = 0: x' = (t sin t)' x. Whether P = 1 or P = 0, K grows with the
    // interval beyond all bounds.
    const auto one_by_one = [](double T) {
        return problem{[](double t) { return MatrixXd(MatrixXd::Constant(1, 1, std::exp(t * std::sin(t)))); },
                       0, T, MatrixXd::Identity(1, 1), MatrixXd::Zero(1, 1)};
    };
    const MatrixXd yes = MatrixXd::Identity(1, 1), no = MatrixXd::Zero(1, 1);
    for (const MatrixXd& P : {yes, no}) {
        const double shorter = theory::dichotomy_constant<double>(one_by_one(6), P, 0, 0, 200),
                     longer = theory::dichotomy_constant<double>(one_by_one(20), P, 0, 0, 400);
        BOOST_TEST(longer > 1e6 * shorter);
    }
}

BOOST_AUTO_TEST_CASE(satz_4_6_part_1_bounds_greens_function_for_conditions_that_fit_the_dichotomy) {
    std::mt19937 generator(461);
    for (int k = 0; k < 40; ++k) {
        const MatrixXd V = random_matrix(generator, 2, 2), P = V * first * V.inverse();
        // B0 X(0) (1 - P) = 0, BT X(T) P = 0: any B0 and BT behind these projectors
        const problem free = modes(V, Eigen::Vector2d(-2, 3), 1, one, nothing);
        const MatrixXd B0 = random_matrix(generator, 2, 2) * P,
                       BT = random_matrix(generator, 2, 2) * (one - P) * free.inverse(free.X(1));
        const problem p{free.X, 0, 1, B0, BT};
        const double K = theory::dichotomy_constant<double>(p, P, 2, 3, 10);
        BOOST_TEST(K > 1);
        BOOST_TEST(p.kappa2(10) <= K * (1 + 1e-8));
        double most = 0;
        for (int i = 0; i <= 10; ++i)
            for (int j = 0; j <= 10; ++j) {
                const double t = p.at(i, 10), s = p.at(j, 10);
                most = std::max(most, theory::two_norm<double>(p.green(t, s)) /
                                          (s <= t ? std::exp(-2 * (t - s)) : std::exp(-3 * (s - t))));
            }
        BOOST_TEST(most <= K * (1 + 1e-8));
    }
}

BOOST_AUTO_TEST_CASE(satz_4_6_part_2_the_projector_needs_ranks_that_add_up_to_m) {
    std::mt19937 generator(462);
    const MatrixXd V = random_matrix(generator, 3, 3);
    const Eigen::Vector3d rates(-2, 1, 3);
    const auto projector = [](const problem& p) {
        return MatrixXd(p.inverse(p.solvability()) * p.B0 * p.X(0));
    };
    for (int k = 0; k < 60; ++k) {
        const Eigen::Index rank = 1 + k % 2;
        const MatrixXd B0 = random_matrix(generator, 3, rank) * random_matrix(generator, rank, 3),
                       BT = random_matrix(generator, 3, 3 - rank) * random_matrix(generator, 3 - rank, 3);
        const problem p = modes(V, rates, 1, B0, BT);
        const MatrixXd P = projector(p);
        BOOST_TEST((P * P - P).norm() < 1e-7 * (1 + P.norm() * P.norm()));
        // "dichotomic with the same constants": with alpha = beta = 0, K is kappa2
        BOOST_TEST(theory::dichotomy_constant<double>(p, P, 0, 0, 10) <= p.kappa2(10) * (1 + 1e-7));
        // ranks that add up to more than m: no projector
        const problem full = modes(V, rates, 1, random_matrix(generator, 3, 3), BT);
        const MatrixXd Q = projector(full);
        BOOST_TEST((Q * Q - Q).norm() > 1e-3);
    }
    // x(0) = x(1) for x' = diag(-2, 3) x: ranks 2 + 2. P = diag(1/(1 - e^-2), 1/(1 - e^3)), kappa2 = 1/(1 - e^-2).
    const problem periodic = modes(one, Eigen::Vector2d(-2, 3), 1, one, -one);
    const MatrixXd P = projector(periodic);
    const double a = 1 / (1 - std::exp(-2.0)), b = 1 / (1 - std::exp(3.0));
    BOOST_TEST((P - diagonal(Eigen::Vector2d(a, b))).cwiseAbs().maxCoeff() < 1e-14);
    BOOST_TEST(periodic.kappa2(40) == a, boost::test_tools::tolerance(1e-12));  // 1.1565
    BOOST_TEST((P * P - P).cwiseAbs().maxCoeff() == a * a - a,
               boost::test_tools::tolerance(1e-12));  // 0.1810
}

BOOST_AUTO_TEST_CASE(the_estimate_with_kappa_1_and_kappa_2_holds_for_systems_and_needs_both_terms) {
    // x' = A x + q, q constant: x(t) = X(t) (x0 + A^-1 q) - A^-1 q.
    std::mt19937 generator(46);
    double largest_of_d = 0, largest_of_q = 0;
    for (int k = 0; k < 300; ++k) {
        const MatrixXd V = random_matrix(generator, 2, 2);
        const Eigen::Vector2d rates = random_matrix(generator, 2, 1), d = random_matrix(generator, 2, 1);
        const double T = 1 + k % 3;
        const problem p = modes(V, rates, T, random_matrix(generator, 2, 2), random_matrix(generator, 2, 2));
        const Eigen::Vector2d q = random_matrix(generator, 2, 1),
                              shift = V * diagonal(rates.cwiseInverse()) * V.inverse() * q;
        const double k1 = p.kappa1(40), k2 = p.kappa2(40);
        const auto largest = [&](const Eigen::Vector2d& data, const Eigen::Vector2d& s) {
            const Eigen::Vector2d x0 = p.inverse(p.solvability()) * (data - p.BT * (p.X(T) * s - s));
            double x = 0;
            for (int i = 0; i <= 40; ++i) x = std::max(x, (p.X(p.at(i, 40)) * (x0 + s) - s).norm());
            return x;
        };
        BOOST_TEST(largest(d, shift) <= (k1 * d.norm() + k2 * T * q.norm()) * (1 + 1e-6));
        largest_of_d = std::max(largest_of_d, largest(d, 0 * shift) / (k1 * d.norm()));
        largest_of_q = std::max(largest_of_q, largest(0 * d, shift) / (k2 * T * q.norm()));
    }
    // Either term alone is reached: to a per cent that of d, and that of q but for the growth within [0, T].
    BOOST_TEST((largest_of_d > 0.99 && largest_of_d <= 1 + 1e-6));
    BOOST_TEST((largest_of_q > 0.5 && largest_of_q <= 1 + 1e-6));
}
