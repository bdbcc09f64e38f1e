// SPDX-License-Identifier: BSL-1.0
// Differential-algebraic equations with constructed solutions: f(t, w) = s'(t) + Phi(w) - Phi(w exact), and
// likewise for the constraints, Phi linear with a small curvature.
#include "problem.hpp"

namespace campaign {

namespace {

/// n x n with eigenvalues near -(0.1 ... fastest) in rotated axes.
MatrixXd decaying(dice& d, int n, double fastest) {
    VectorXd lambda(n);
    for (int i = 0; i < n; ++i) lambda[i] = -d.log_between(0.1, fastest);
    const MatrixXd Q = d.rotation(n);
    return Q * lambda.asDiagonal() * Q.transpose();
}

MatrixXd beside(const MatrixXd& a, const MatrixXd& b) {
    MatrixXd c(a.rows(), a.cols() + b.cols());
    c << a, b;
    return c;
}

std::vector<int> flags(int ones, int rest, int of_rest) {
    std::vector<int> all(static_cast<std::size_t>(ones), 1);
    all.insert(all.end(), static_cast<std::size_t>(rest), of_rest);
    return all;
}

/// y' = s' + Phi(y, z) - Phi(s, sigma), 0 = Gamma(y, z) - Gamma(s, sigma).
problem constructed(dice& d, int n, int m, const curved_map& phi, const curved_map& gamma, int index) {
    problem p;
    const waves s(d, n), sigma(d, m);
    p.t1 = d.log_between(0.03, 10);
    p.differential = n;
    p.index = flags(n, m, index);
    p.exact = [=](double t) { return joined(s(t), sigma(t)); };
    p.y0 = p.exact(0);
    const auto exact = p.exact;
    p.f = [=](double t, const VectorXd& w, VectorXd& f) {
        const VectorXd e = exact(t);
        f.head(n) = s.rate(t) + phi(w) - phi(e);
        f.tail(m) = gamma(w) - gamma(e);
    };
    p.jacobian = [=](double, const VectorXd& w, MatrixXd& J) {
        J.topRows(n) = phi.derivative(w);
        J.bottomRows(m) = gamma.derivative(w);
    };
    p.description =
        "n = " + std::to_string(n) + ", m = " + std::to_string(m) + ", t1 = " + std::to_string(p.t1);
    return p;
}

}  // namespace

problem index_1(dice d) {
    const int n = d.integer(1, 4), m = d.integer(1, 3);
    const curved_map phi(d, beside(decaying(d, n, 1e5), d.matrix(n, m, 0.3)), 0.05);
    const MatrixXd g_z = MatrixXd::Identity(m, m) * d.sign() * d.log_between(0.5, 10) + d.matrix(m, m, 0.1);
    const curved_map gamma(d, beside(d.matrix(m, n, 0.3), g_z), 0.02);
    return constructed(d, n, m, phi, gamma, 1);
}

/// In rotated axes y = (a; b): the constraint is b = -C a + ..., z acts on b alone, a decays.
problem index_2(dice d) {
    const int m = d.integer(1, 2), free = d.integer(0, 3), n = m + free;
    const MatrixXd Q = d.rotation(n);
    MatrixXd A = d.matrix(n, n, 0.3), B = MatrixXd::Zero(n, m), G = MatrixXd::Zero(m, n);
    if (free > 0) A.topLeftCorner(free, free) = decaying(d, free, 1e4);
    for (int i = 0; i < m; ++i) B(free + i, i) = d.sign() * d.log_between(0.5, 2);
    G.rightCols(m).setIdentity();
    G.leftCols(free) = d.matrix(m, free, 0.5);
    curved_map phi(d, beside(Q * A * Q.transpose(), Q * B), 0.05);
    curved_map gamma(d, beside(G * Q.transpose(), MatrixXd::Zero(m, m)), 0.05);
    phi.R.rightCols(m).setZero();
    gamma.R.rightCols(m).setZero();
    return constructed(d, n, m, phi, gamma, 2);
}

/// q' = v, v' = s'' + Phi(q, v) - Phi(s, s') + Gamma_q(q)^T lambda - Gamma_q(s)^T sigma, 0 = Gamma(q) - Gamma(s),
/// Phi of springs and dampers.
problem index_3(dice d) {
    problem p;
    const int m = d.integer(1, 2), n = m + d.integer(1, 2);
    const curved_map phi(d, beside(decaying(d, n, 100), decaying(d, n, 2)), 0.02);
    MatrixXd G = d.matrix(m, n, 0.4);
    G.rightCols(m) += MatrixXd::Identity(m, m);
    const curved_map gamma(d, G, 0.05);
    const waves s(d, n), sigma(d, m);
    p.t1 = d.log_between(0.1, 10);
    p.differential = 2 * n;
    p.index = flags(n, n, 2);
    p.index.insert(p.index.end(), static_cast<std::size_t>(m), 3);
    p.exact = [=](double t) { return joined(joined(s(t), s.rate(t)), sigma(t)); };
    p.y0 = p.exact(0);
    p.f = [=](double t, const VectorXd& w, VectorXd& f) {
        const VectorXd q = w.head(n), qe = s(t);
        f.head(n) = w.segment(n, n);
        f.segment(n, n) = s.second(t) + phi(w.head(2 * n)) - phi(joined(qe, s.rate(t))) +
                          gamma.derivative(q).transpose() * w.tail(m) -
                          gamma.derivative(qe).transpose() * sigma(t);
        f.tail(m) = gamma(q) - gamma(qe);
    };
    p.jacobian = [=](double, const VectorXd& w, MatrixXd& J) {
        const VectorXd q = w.head(n);
        J.setZero();
        J.block(0, n, n, n).setIdentity();
        J.block(n, 0, n, 2 * n) = phi.derivative(w.head(2 * n));
        J.block(n, 0, n, n) += gamma.second(w.tail(m));
        J.block(n, 2 * n, n, m) = gamma.derivative(q).transpose();
        J.block(2 * n, 0, m, n) = gamma.derivative(q);
    };
    p.description =
        "n = " + std::to_string(n) + ", m = " + std::to_string(m) + ", t1 = " + std::to_string(p.t1);
    return p;
}

}  // namespace campaign
