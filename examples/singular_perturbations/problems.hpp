// SPDX-License-Identifier: BSL-1.0
// Singular perturbation problems M y' = f(t, y), M = diag(1, ..., eps, ...), each from a start off its slow manifold.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <complex>

namespace perturbed_problems {

/// Van der Pol's relaxation oscillation in Lienard's variables, y' = -z, eps z' = y - (z^3/3 - z): a layer at the start, and
/// two jumps.
struct van_der_pol {
    static constexpr const char* name = "van der Pol";
    static constexpr int size = 2;
    static constexpr double t0 = 0, t1 = 2, atol_scale = 1;
    double eps;
    static Eigen::Vector2d initial() { return {1, 2}; }
    void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const {
        f << -y[1], y[0] - (y[1] * y[1] / 3 - 1) * y[1];
    }
    void jacobian(double, const Eigen::Vector2d& y, Eigen::Matrix2d& J) const {
        J << 0, -1, 1, 1 - y[1] * y[1];
    }
    Eigen::Matrix2d mass() const { return Eigen::Vector2d(1, eps).asDiagonal(); }
};

/// A fast enzyme, as in examples/lessons/singular_perturbation.cpp.
struct enzyme {
    static constexpr const char* name = "enzyme";
    static constexpr int size = 2;
    static constexpr double t0 = 0, t1 = 1, atol_scale = 1;
    double eps;
    static Eigen::Vector2d initial() { return {1, 0}; }
    void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const {
        f << -y[0] + (y[0] + 0.5) * y[1], y[0] - (y[0] + 1) * y[1];
    }
    void jacobian(double, const Eigen::Vector2d& y, Eigen::Matrix2d& J) const {
        J << -1 + y[1], y[0] + 0.5, 1 - y[1], -(y[0] + 1);
    }
    Eigen::Matrix2d mass() const { return Eigen::Vector2d(1, eps).asDiagonal(); }
};

/// A ladder of eight resistors behind a source sin 3t. Nodes 0 ... 3 have a capacitor of 1 to earth, the nodes 4 ... 7 between
/// them one of eps only. The start is the periodic solution, V with (3 i M + G) V = b, but for the nodes of eps, which are at 0.
struct ladder {
    static constexpr const char* name = "RC ladder";
    static constexpr int size = 8;
    static constexpr double t0 = 0, t1 = 10, atol_scale = 1;
    using vector = Eigen::Matrix<double, size, 1>;
    using matrix = Eigen::Matrix<double, size, size>;
    double eps;
    matrix G = conductances();

    static matrix conductances() {
        matrix G = matrix::Zero();
        int before = -1;  // the source
        for (const int node : {4, 0, 5, 1, 6, 2, 7, 3}) {
            G(node, node) += 1;
            if (before >= 0) G(before, before) += 1, G(node, before) -= 1, G(before, node) -= 1;
            before = node;
        }
        return G;
    }
    vector initial() const { return periodic(0); }
    vector periodic(double t) const {
        const std::complex<double> i(0, 1);
        const Eigen::Matrix<std::complex<double>, size, size> A = 3.0 * i * mass() + G;
        return (A.partialPivLu().solve(vector::Unit(4).cast<std::complex<double>>()) * std::exp(3.0 * i * t))
            .imag();
    }
    void operator()(double t, const vector& y, vector& f) const {
        f.noalias() = -G * y;
        f[4] += std::sin(3 * t);
    }
    void jacobian(double, const vector&, matrix& J) const { J = -G; }
    matrix mass() const {
        vector capacities = vector::Ones();
        capacities.tail<4>().setConstant(eps);
        return capacities.asDiagonal();
    }
};

}  // namespace perturbed_problems
