// SPDX-License-Identifier: BSL-1.0
#define BOOST_TEST_MODULE two_point_matrix
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <problems/dense_once.hpp>
#include <random>
#include <stagecraft/linear/two_point_matrix.hpp>

namespace sc = stagecraft;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// The same equations as one dense matrix, unknowns y_0, ..., y_L, p.
struct dense {
    MatrixXd A;
    VectorXd right;
};

struct problem {
    int n, intervals, parameters;
    std::vector<MatrixXd> blocks;
    MatrixXd conditions, g;
    VectorXd beta;

    dense assembled() const {
        const int all = n * (intervals + 1) + parameters;
        dense d{MatrixXd::Zero(all, all), VectorXd(all)};
        for (int i = 0; i < intervals; ++i) {
            d.A.block(i * n, i * n, n, 2 * n) = blocks[i].leftCols(2 * n);
            d.A.block(i * n, n * (intervals + 1), n, parameters) = blocks[i].rightCols(parameters);
            d.right.segment(i * n, n) = g.col(i);
        }
        const int last = n * intervals, rows = n + parameters;
        d.A.block(last, 0, rows, n) = conditions.leftCols(n);
        d.A.block(last, last, rows, n) = conditions.middleCols(n, n);
        d.A.bottomRightCorner(rows, parameters) = conditions.rightCols(parameters);
        d.right.tail(rows) = beta;
        return d;
    }

    template <class Matrix>
    void give(Matrix& m) const {
        m.start(n, intervals, conditions);
        for (int i = 0; i < intervals; ++i) m.set(i, blocks[i]);
        BOOST_TEST(m.factor() == 0);
    }
};

problem random(int n, int intervals, int parameters, bool separated) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto fill = [&](auto& m) {
        for (Eigen::Index k = 0; k < m.size(); ++k) m.data()[k] = number(generator);
    };
    problem p{n,
              intervals,
              parameters,
              {},
              MatrixXd(n + parameters, 2 * n + parameters),
              MatrixXd(n, intervals),
              VectorXd(n + parameters)};
    for (int i = 0; i < intervals; ++i) {
        p.blocks.emplace_back(n, 2 * n + parameters);
        fill(p.blocks.back());
    }
    fill(p.conditions), fill(p.g), fill(p.beta);
    if (separated)
        for (int r = 0; r < n; ++r) p.conditions.row(r).segment(r % 2 == 0 ? n : 0, n).setZero();
    return p;
}

template <int N>
void agrees_with_dense_elimination(int n, int intervals, int parameters, bool separated) {
    const problem p = random(n, intervals, parameters, separated);
    sc::two_point_matrix<double, N> m;
    p.give(m);
    BOOST_TEST(m.separated() == (separated && parameters == 0));
    MatrixXd y(n, intervals + 1);
    VectorXd q(parameters);
    m.solve(p.g, p.beta, y, q);
    const dense d = p.assembled();
    VectorXd x(d.right.size());
    x << y.reshaped(), q;
    const double size = d.A.cwiseAbs().rowwise().sum().maxCoeff() * x.cwiseAbs().maxCoeff();
    BOOST_TEST((d.A * x - d.right).cwiseAbs().maxCoeff() < 1e-14 * size);

    // Transposed: weights of the unknowns in, weights of the equations out.
    MatrixXd weights(n, intervals);
    VectorXd of_conditions(n + parameters);
    m.solve_transposed(y, q, weights, of_conditions);
    VectorXd w(d.right.size());
    w << weights.reshaped(), of_conditions;
    const double transposed = d.A.cwiseAbs().colwise().sum().maxCoeff() * w.cwiseAbs().maxCoeff();
    BOOST_TEST((d.A.transpose() * w - x).cwiseAbs().maxCoeff() < 1e-14 * transposed);
}

// x' = [[-1/6, 1], [1, -1/6]] x, x(0) + x(60) = d, shooting over equal intervals (Wright 1993).
problem wright(int intervals) {
    const double h = 60.0 / intervals, decay = std::exp(-h / 6);
    MatrixXd X(2, 2);
    X << decay * std::cosh(h), decay * std::sinh(h), decay * std::sinh(h), decay * std::cosh(h);
    problem p{2, intervals, 0, {}, MatrixXd(2, 4), MatrixXd::Zero(2, intervals), VectorXd::Ones(2)};
    p.beta[1] = 0.25;
    MatrixXd block(2, 4);
    block << -X, MatrixXd::Identity(2, 2);
    p.blocks.assign(intervals, block);
    p.conditions << MatrixXd::Identity(2, 2), MatrixXd::Identity(2, 2);
    return p;
}

}  // namespace

BOOST_AUTO_TEST_CASE(separated_coupled_and_bordered_conditions_are_solved_as_by_dense_elimination) {
    agrees_with_dense_elimination<3>(3, 6, 0, true);
    agrees_with_dense_elimination<3>(3, 6, 0, false);
    agrees_with_dense_elimination<3>(3, 5, 2, false);
    agrees_with_dense_elimination<3>(3, 1, 1, false);
    agrees_with_dense_elimination<2>(2, 1, 0, true);
    agrees_with_dense_elimination<Eigen::Dynamic>(4, 7, 0, true);
    agrees_with_dense_elimination<Eigen::Dynamic>(4, 7, 3, false);
}

BOOST_AUTO_TEST_CASE(orthogonal_elimination_is_stable_where_row_pivoting_fails) {
    const problem p = wright(200);
    sc::two_point_matrix<double, 2> m;
    p.give(m);
    MatrixXd y(2, 201);
    VectorXd none(0);
    m.solve(p.g, p.beta, y, none);
    const dense d = p.assembled();
    const VectorXd x = y.reshaped();
    const double size = d.A.cwiseAbs().rowwise().sum().maxCoeff() * x.cwiseAbs().maxCoeff() + 1;
    BOOST_TEST((d.A * x - d.right).cwiseAbs().maxCoeff() <= 1e-13 * size);
    // x = c1 e^{5t/6} (1, 1) + c2 e^{-7t/6} (1, -1).
    const double c1 = 0.625 / (1 + std::exp(50.0)), c2 = 0.375 / (1 + std::exp(-70.0));
    for (int i = 0; i <= 200; ++i) {
        const double t = 0.3 * i, grow = c1 * std::exp(5 * t / 6), fall = c2 * std::exp(-7 * t / 6);
        BOOST_TEST(std::abs(y(0, i) - (grow + fall)) < 1e-13);
        BOOST_TEST(std::abs(y(1, i) - (grow - fall)) < 1e-13);
    }
    // Row pivoting on the same matrix loses everything.
    const VectorXd by_rows = d.A.partialPivLu().solve(d.right);
    BOOST_TEST(!((d.A * by_rows - d.right).cwiseAbs().maxCoeff() <= 1e-3 * size));
}

BOOST_AUTO_TEST_CASE(a_zero_pivot_is_counted_and_replaced) {
    problem p = random(2, 3, 0, true);
    p.conditions.row(1).setZero();
    sc::two_point_matrix<double, 2> m;
    m.start(p.n, p.intervals, p.conditions);
    for (int i = 0; i < p.intervals; ++i) m.set(i, p.blocks[i]);
    BOOST_TEST(m.factor() == 1);
}
