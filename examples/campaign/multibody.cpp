// SPDX-License-Identifier: BSL-1.0
// A chain of four to six masses on rigid rods with stiff springs across, 20 to 30 unknowns, index 2 or 3, whose
// Jacobian is exact, has its constant and constraint blocks only, or is off by 10 % in every entry.
#include <Eigen/Cholesky>
#include <memory>

#include "problem.hpp"

namespace campaign {

namespace {

struct chain {
    int masses;
    VectorXd stiffness, damping;  // of the springs between masses i and i + 2, and of every coordinate
    bool position;                // constraints of position (index 3) or of velocity (index 2)
    static constexpr double g = 9.81;

    int n() const { return 2 * masses; }
    int size() const { return 5 * masses; }

    /// q_i - q_{i-1}, mass 0 being the support at the origin.
    Eigen::Vector2d rod(const VectorXd& q, int i) const {
        return q.segment<2>(2 * i) -
               (i > 0 ? Eigen::Vector2d(q.segment<2>(2 * i - 2)) : Eigen::Vector2d(0, 0));
    }
    MatrixXd G(const VectorXd& q) const {
        MatrixXd G = MatrixXd::Zero(masses, n());
        for (int i = 0; i < masses; ++i) {
            G.block<1, 2>(i, 2 * i) = 2 * rod(q, i).transpose();
            if (i > 0) G.block<1, 2>(i, 2 * i - 2) = -2 * rod(q, i).transpose();
        }
        return G;
    }
    /// Linear springs between masses i and i + 2, in x and y.
    MatrixXd K() const {
        MatrixXd K = MatrixXd::Zero(n(), n());
        for (int i = 0; i + 2 < masses; ++i)
            for (int x = 0; x < 2; ++x) {
                const int a = 2 * i + x, b = 2 * i + 4 + x;
                K(a, a) += stiffness[i], K(b, b) += stiffness[i];
                K(a, b) -= stiffness[i], K(b, a) -= stiffness[i];
            }
        return K;
    }
    MatrixXd curvature(const VectorXd& w) const {  // the derivative of G(q)^T w by q
        MatrixXd C = MatrixXd::Zero(n(), n());
        for (int i = 0; i < masses; ++i)
            for (int x = 0; x < 2; ++x) {
                const int a = 2 * i + x, b = a - 2;
                C(a, a) += 2 * w[i];
                if (i == 0) continue;
                C(b, b) += 2 * w[i];
                C(a, b) -= 2 * w[i], C(b, a) -= 2 * w[i];
            }
        return C;
    }
    MatrixXd moving(const VectorXd& v) const {
        return G(v);
    }  // the derivative of G(q) v by q: G is linear in q
};

enum class quality { exact, blocks, perturbed };

void write_jacobian(const chain& c, const VectorXd& y, quality kind, const MatrixXd& noise, MatrixXd& J) {
    const int n = c.n(), m = c.masses;
    J.setZero();
    J.block(0, n, n, n).setIdentity();
    const MatrixXd G = c.G(y.head(n));
    J.block(n, 2 * n, n, m) = -G.transpose();
    if (c.position)
        J.block(2 * n, 0, m, n) = G;
    else
        J.block(2 * n, n, m, n) = G;
    if (kind == quality::blocks) return;
    J.block(n, 0, n, n) = -c.K() - c.curvature(y.tail(m));
    J.block(n, n, n, n).diagonal() = -c.damping;
    if (!c.position) J.block(2 * n, 0, m, n) = c.moving(y.segment(n, n));
    if (kind == quality::perturbed) J = J.cwiseProduct(noise);
}

}  // namespace

problem approximate(dice d) {
    problem p;
    const auto c = std::make_shared<chain>();
    c->masses = d.integer(4, 6);
    c->position = d.coin();
    const quality kind = static_cast<quality>(d.integer(0, 2));
    const int n = c->n(), m = c->masses, size = c->size();
    c->stiffness = VectorXd(m);
    for (int i = 0; i < m; ++i) c->stiffness[i] = d.log_between(1e2, 1e5);
    c->damping = VectorXd::Constant(n, d.log_between(0.1, 10));
    const MatrixXd noise = MatrixXd::Ones(size, size) + d.matrix(size, size, 0.1);
    p.t1 = d.between(0.2, 1);
    p.differential = 2 * n;
    // Rods of length one at random angles, at rest; lambda from 0 = G q'' there.
    VectorXd q(n);
    for (int i = 0; i < m; ++i) {
        const double a = d.between(-1.2, 1.2);
        q.segment<2>(2 * i) = Eigen::Vector2d(std::sin(a), -std::cos(a));
        if (i > 0) q.segment<2>(2 * i) += q.segment<2>(2 * i - 2);
    }
    // Springs are unstressed at the start.
    const VectorXd rest = c->K() * q;
    VectorXd gravity = VectorXd::Zero(n);
    for (int i = 0; i < m; ++i) gravity[2 * i + 1] = -chain::g;
    const MatrixXd G = c->G(q);
    const VectorXd lambda = (G * G.transpose()).ldlt().solve(G * gravity);
    p.y0 = joined(joined(q, VectorXd::Zero(n)), lambda);
    VectorXd lengths(m);
    for (int i = 0; i < m; ++i) lengths[i] = c->rod(q, i).squaredNorm();
    p.f = [=](double, const VectorXd& y, VectorXd& f) {
        const VectorXd q = y.head(n), v = y.segment(n, n);
        const MatrixXd G = c->G(q);
        f.head(n) = v;
        f.segment(n, n) =
            gravity + rest - c->K() * q - c->damping.cwiseProduct(v) - G.transpose() * y.tail(m);
        if (c->position)
            for (int i = 0; i < m; ++i) f[2 * n + i] = c->rod(q, i).squaredNorm() - lengths[i];
        else
            f.tail(m) = G * v;
    };
    p.jacobian = [=](double, const VectorXd& y, MatrixXd& J) { write_jacobian(*c, y, kind, noise, J); };
    p.index.assign(static_cast<std::size_t>(2 * n), 1);
    p.index.insert(p.index.end(), static_cast<std::size_t>(m), c->position ? 3 : 2);
    if (c->position) std::fill(p.index.begin() + n, p.index.begin() + 2 * n, 2);
    p.exact_everywhere = false;
    // The same of index 2 with the exact Jacobian at a tight tolerance, at the end.
    problem tight = p;
    const auto free = std::make_shared<chain>(*c);
    free->position = false;
    tight.f = [=, f = p.f](double t, const VectorXd& y, VectorXd& out) {
        f(t, y, out);
        out.tail(m) = c->G(y.head(n)) * y.segment(n, n);
    };
    tight.jacobian = [=](double, const VectorXd& y, MatrixXd& J) {
        write_jacobian(*free, y, quality::exact, noise, J);
    };
    tight.index.assign(static_cast<std::size_t>(2 * n), 1);
    tight.index.insert(tight.index.end(), static_cast<std::size_t>(m), 2);
    p.exact = [end = end_state(tight, 1e-12)](double) { return end; };
    const char* names[] = {"exact", "blocks only", "off by 10 %"};
    p.description = std::to_string(size) + " unknowns, index " + (c->position ? "3" : "2") + ", Jacobian " +
                    names[static_cast<int>(kind)];
    return p;
}

}  // namespace campaign
