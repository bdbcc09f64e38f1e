// SPDX-License-Identifier: BSL-1.0
// Ordinary differential equations: linear ones from large t0, nonlinear ones with curved slow manifolds, one stiff
// component on a wave.
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>

#include "problem.hpp"

namespace campaign {

/// y' = A y with real and complex eigenvalues to -1e6 and a basis that is not orthogonal, from t0 in 0 ... 1e11;
/// the solution by a matrix exponential in long double. Eigenvalues are kept where t resolves their time scale.
problem linear(dice d) {
    problem p;
    const int n = d.integer(1, 6);
    const double starts[] = {0, 0, 1, 1e3, 1e6, 1e9, 1e11};
    p.t0 = starts[d.integer(0, 6)];
    const double ulp = std::nextafter(p.t0, INFINITY) - p.t0;
    const double fastest = std::min(1e6, 0.01 / ulp);
    MatrixXd blocks = MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
        blocks(i, i) = -d.log_between(0.1, fastest);
        if (i + 1 == n || d.coin()) continue;
        const double omega = std::min(std::abs(blocks(i, i)), 30.0) * d.between(0, 1);
        blocks(i + 1, i + 1) = blocks(i, i);
        blocks(i, i + 1) = omega;
        blocks(i + 1, i) = -omega;
        ++i;
    }
    const MatrixXd basis = MatrixXd::Identity(n, n) + d.matrix(n, n, 0.5 / n);
    const MatrixXd Q = d.rotation(n);
    const MatrixXd B = Q * basis * blocks * basis.inverse() * Q.transpose();
    p.t1 = p.t0 + d.log_between(0.1, 10);
    p.y0 = d.vector(n);
    p.f = [B](double, const VectorXd& y, VectorXd& f) { f.noalias() = B * y; };
    p.jacobian = [B](double, const VectorXd&, MatrixXd& J) { J = B; };
    using wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    const wide scaled = B.cast<long double>() * (static_cast<long double>(p.t1) - p.t0);
    const wide exponential = scaled.exp();
    const VectorXd end = (exponential * p.y0.cast<long double>()).cast<double>();
    p.exact = [end](double) { return end; };
    p.exact_everywhere = false;
    p.description = "n = " + std::to_string(n) + ", t0 = " + std::to_string(p.t0);
    return p;
}

/// y = Q phi(u), phi_i(u) = u_i + sum_{j < i} a_ij u_j^2, where u_i' = lambda_i (u_i - s_i(t)) + s_i'(t) starts
/// off the slow solution s: stiff components return to a curved manifold.
problem nonlinear(dice d) {
    problem p;
    const int n = d.integer(2, 6);
    const MatrixXd Q = d.rotation(n);
    MatrixXd a = d.matrix(n, n, 0.5);
    a.triangularView<Eigen::Upper>().setZero();
    VectorXd lambda(n);
    for (int i = 0; i < n; ++i) lambda[i] = -d.log_between(0.1, 1e6);
    const waves s(d, n);
    p.t1 = d.log_between(0.1, 20);
    const VectorXd off = s(0) + d.vector(n, 0.5);
    const auto u_of = [=](const VectorXd& y) {
        VectorXd u = Q.transpose() * y;
        for (int i = 1; i < n; ++i) u[i] -= a.row(i).head(i).dot(u.head(i).cwiseAbs2());
        return u;
    };
    const auto phi = [=](const VectorXd& u) { return VectorXd(u + a * u.cwiseAbs2()); };
    const auto slope = [=](double t, const VectorXd& u) {
        return VectorXd(lambda.cwiseProduct(u - s(t)) + s.rate(t));
    };
    const auto derivative = [=](const VectorXd& u) {
        return MatrixXd(MatrixXd::Identity(n, n) + 2 * a * u.asDiagonal());
    };
    p.f = [=](double t, const VectorXd& y, VectorXd& f) {
        const VectorXd u = u_of(y);
        f = Q * (derivative(u) * slope(t, u));
    };
    p.jacobian = [=](double t, const VectorXd& y, MatrixXd& J) {
        const VectorXd u = u_of(y);
        const MatrixXd D = derivative(u);
        const MatrixXd by_u = D * lambda.asDiagonal() + 2 * a * slope(t, u).asDiagonal().toDenseMatrix();
        J = Q * by_u * D.triangularView<Eigen::UnitLower>().solve(MatrixXd(Q.transpose()));
    };
    const VectorXd from = off - s(0);
    p.exact = [=](double t) {
        return VectorXd(Q * phi(s(t) + ((lambda * t).array().exp() * from.array()).matrix()));
    };
    p.y0 = p.exact(0);
    p.description = "n = " + std::to_string(n) + ", t1 = " + std::to_string(p.t1);
    return p;
}

/// y' = lambda (y - g) + g', y(0) = g(0), one component on a wave g of amplitude 0.1 ... 10 (Hairer-Wanner
/// II.IV.15): the steps may hold most of a turn of it, and the phase decides what an estimate sees.
problem signal(dice d) {
    problem p;
    const double lambda = -d.log_between(1e2, 1e7), a = d.log_between(0.1, 10),
                 omega = d.log_between(0.1, 100), phase = d.between(0, 6.3);
    p.t1 = d.between(1, 20);
    const auto g = [=](double t) { return 1 + a * std::sin(omega * t + phase); };
    p.f = [=](double t, const VectorXd& y, VectorXd& f) {
        f[0] = lambda * (y[0] - g(t)) + a * omega * std::cos(omega * t + phase);
    };
    p.jacobian = [=](double, const VectorXd&, MatrixXd& J) { J(0, 0) = lambda; };
    p.exact = [=](double t) { return VectorXd(VectorXd::Constant(1, g(t))); };
    p.y0 = p.exact(0);
    p.description = "lambda = " + std::to_string(lambda) + ", omega = " + std::to_string(omega);
    return p;
}

}  // namespace campaign
