// SPDX-License-Identifier: BSL-1.0
// Stiff test problems for tests and for the comparison of solvers, each as a plain struct: right-hand side, size,
// interval, initial value, Jacobian.
// `atol_scale` is the customary ratio atol/rtol; reference solutions are in data/<name>.json.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cmath>
#include <numbers>
#include <problems/equations.hpp>
#include <stagecraft/linear/banded_matrix.hpp>
#include <vector>

namespace problems {

template <class S, int N>
using vec = Eigen::Matrix<S, N, 1>;

/// Van der Pol, eps = 1e-6 (Hairer-Wanner II, IV.10).
struct van_der_pol : equations::van_der_pol {
    static constexpr const char* name = "vdpol";
    static constexpr int size = 2;
    static constexpr double t0 = 0, t1 = 2, atol_scale = 1;
    static vec<double, 2> initial() { return {2, -0.66}; }

    void jacobian(double, const vec<double, 2>& y, Eigen::Matrix2d& J) const {
        J << 0, 1, (-2 * y[0] * y[1] - 1) / epsilon, (1 - y[0] * y[0]) / epsilon;
    }
};

/// Robertson's reaction, to t = 1e11 (Hairer-Wanner II, IV.10).
struct robertson : equations::robertson {
    static constexpr const char* name = "rober";
    static constexpr int size = 3;
    static constexpr double t0 = 0, t1 = 1e11, atol_scale = 1e-6;
    static vec<double, 3> initial() { return {1, 0, 0}; }

    void jacobian(double, const vec<double, 3>& y, Eigen::Matrix3d& J) const {
        J << -0.04, 1e4 * y[2], 1e4 * y[1], 0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1], 0, 6e7 * y[1], 0;
    }
};

/// The Oregonator (Hairer-Wanner II, IV.10).
struct oregonator : equations::oregonator {
    static constexpr const char* name = "orego";
    static constexpr int size = 3;
    static constexpr double t0 = 0, t1 = 360, atol_scale = 1e-6;
    static vec<double, 3> initial() { return {1, 2, 3}; }

    void jacobian(double, const vec<double, 3>& y, Eigen::Matrix3d& J) const {
        J << 77.27 * (1 - 2 * 8.375e-6 * y[0] - y[1]), 77.27 * (1 - y[0]), 0,  //
            -y[1] / 77.27, -(1 + y[0]) / 77.27, 1 / 77.27,                     //
            0.161, 0, -0.161;
    }
};

/// HIRES, high irradiance response of photomorphogenesis (Hairer-Wanner II, IV.10).
struct hires : equations::hires {
    static constexpr const char* name = "hires";
    static constexpr int size = 8;
    static constexpr double t0 = 0, t1 = 321.8122, atol_scale = 1e-4;
    static vec<double, 8> initial() { return {1, 0, 0, 0, 0, 0, 0, 0.0057}; }

    void jacobian(double, const vec<double, 8>& y, Eigen::Matrix<double, 8, 8>& J) const {
        J.setZero();
        J(0, 0) = -1.71, J(0, 1) = 0.43, J(0, 2) = 8.32;
        J(1, 0) = 1.71, J(1, 1) = -8.75;
        J(2, 2) = -10.03, J(2, 3) = 0.43, J(2, 4) = 0.035;
        J(3, 1) = 8.32, J(3, 2) = 1.71, J(3, 3) = -1.12;
        J(4, 4) = -1.745, J(4, 5) = 0.43, J(4, 6) = 0.43;
        J(5, 3) = 0.69, J(5, 4) = 1.71, J(5, 5) = -280 * y[7] - 0.43, J(5, 6) = 0.69, J(5, 7) = -280 * y[5];
        J(6, 5) = 280 * y[7], J(6, 6) = -1.81, J(6, 7) = 280 * y[5];
        J.row(7) = -J.row(6);
    }
};

/// Transistor amplifier, an index-1 DAE M y' = f(t, y) (Hairer-Wanner II, VI.1 and VI.4).
struct transistor_amplifier : equations::transistor_amplifier {
    static constexpr const char* name = "transamp";
    static constexpr int size = 8;
    static constexpr double t0 = 0, t1 = 0.2, atol_scale = 1;
    static vec<double, 8> initial() { return {0, 3, 3, 6, 3, 3, 6, 0}; }
    static constexpr double UF = 0.026, a = 0.99, b = 1e-6, R0 = 1000, R = 9000;

    void jacobian(double, const vec<double, 8>& y, Eigen::Matrix<double, 8, 8>& J) const {
        const double d1 = b / UF * std::exp((y[1] - y[2]) / UF), d2 = b / UF * std::exp((y[4] - y[5]) / UF);
        J.setZero();
        J(0, 0) = 1 / R0;
        J(1, 1) = 2 / R + (1 - a) * d1, J(1, 2) = -(1 - a) * d1;
        J(2, 1) = -d1, J(2, 2) = 1 / R + d1;
        J(3, 1) = a * d1, J(3, 2) = -a * d1, J(3, 3) = 1 / R;
        J(4, 4) = 2 / R + (1 - a) * d2, J(4, 5) = -(1 - a) * d2;
        J(5, 4) = -d2, J(5, 5) = 1 / R + d2;
        J(6, 4) = a * d2, J(6, 5) = -a * d2, J(6, 6) = 1 / R;
        J(7, 7) = 1 / R;
    }
};

/// Kepler's problem, eccentricity 0.6, as q' = v, v' = -q/|q|^3.
struct kepler {
    static constexpr const char* name = "kepler";
    static constexpr int size = 4, second_order_components = 2;
    static constexpr bool nonstiff = true;
    static constexpr double t0 = 0, t1 = 20, atol_scale = 1;
    static vec<double, 4> initial() { return {0.4, 0, 0, 2}; }

    template <class S>
    void operator()(const S&, const vec<S, 4>& y, vec<S, 4>& f) const {
        using std::sqrt;
        const S r2 = y[0] * y[0] + y[1] * y[1], w = 1.0 / (r2 * sqrt(r2));
        f[0] = y[2];
        f[1] = y[3];
        f[2] = -y[0] * w;
        f[3] = -y[1] * w;
    }
    void jacobian(double, const vec<double, 4>& y, Eigen::Matrix4d& J) const {
        const double r2 = y[0] * y[0] + y[1] * y[1], w = 1 / (r2 * std::sqrt(r2)), u = 3 * w / r2;
        J << 0, 0, 1, 0, 0, 0, 0, 1,                     //
            u * y[0] * y[0] - w, u * y[0] * y[1], 0, 0,  //
            u * y[0] * y[1], u * y[1] * y[1] - w, 0, 0;
    }
};

/// One-dimensional Brusselator with diffusion, N grid points, interleaved u, v: bandwidth 2 on either side
/// (Hairer-Wanner II, IV.10). N = 500 has a stored reference.
struct brusselator {
    static constexpr const char* name = "bruss";
    static constexpr int size = Eigen::Dynamic, lower = 2, upper = 2;
    static constexpr double t0 = 0, t1 = 10, atol_scale = 1;
    int N = 500;

    double diffusion() const { return (N + 1.0) * (N + 1.0) / 50; }
    Eigen::VectorXd initial() const {
        Eigen::VectorXd y(2 * N);
        for (int i = 0; i < N; ++i) {
            y[2 * i] = 1 + std::sin(2 * std::numbers::pi * (i + 1) / (N + 1));
            y[2 * i + 1] = 3;
        }
        return y;
    }
    template <class S>
    void operator()(const S&, const vec<S, Eigen::Dynamic>& y, vec<S, Eigen::Dynamic>& f) const {
        const double d = diffusion();
        for (int i = 0; i < N; ++i) {
            const S &u = y[2 * i], &v = y[2 * i + 1];
            const S reaction = u * u * v;
            const S ul = i > 0 ? y[2 * i - 2] : S(1), vl = i > 0 ? y[2 * i - 1] : S(3);
            const S ur = i + 1 < N ? y[2 * i + 2] : S(1), vr = i + 1 < N ? y[2 * i + 3] : S(3);
            f[2 * i] = 1.0 + reaction - 4.0 * u + d * (ul - 2.0 * u + ur);
            f[2 * i + 1] = 3.0 * u - reaction + d * (vl - 2.0 * v + vr);
        }
    }
    stagecraft::bandwidth bandwidth() const { return {lower, upper}; }
    void jacobian(double, const Eigen::VectorXd& y, stagecraft::banded_matrix<double>& J) const {
        jacobian_entries(y, [&](int i, int j, double v) { J(i, j) = v; });
    }
    /// Calls entry(i, j, value) for every nonzero of the Jacobian.
    template <class Entry>
    void jacobian_entries(const Eigen::VectorXd& y, Entry entry) const {
        const double d = diffusion();
        for (int i = 0; i < N; ++i) {
            const double u = y[2 * i], v = y[2 * i + 1];
            entry(2 * i, 2 * i, 2 * u * v - 4 - 2 * d);
            entry(2 * i, 2 * i + 1, u * u);
            entry(2 * i + 1, 2 * i, 3 - 2 * u * v);
            entry(2 * i + 1, 2 * i + 1, -u * u - 2 * d);
            for (const int k : {2 * i, 2 * i + 1}) {
                if (i > 0) entry(k, k - 2, d);
                if (i + 1 < N) entry(k, k + 2, d);
            }
        }
    }
};

/// The same, its Jacobian handed over as a sparse matrix.
struct sparse_brusselator {
    static constexpr const char* name = "bruss-sparse";
    static constexpr int size = Eigen::Dynamic;
    static constexpr double t0 = brusselator::t0, t1 = brusselator::t1, atol_scale = brusselator::atol_scale;
    brusselator base;

    Eigen::VectorXd initial() const { return base.initial(); }
    template <class S>
    void operator()(const S& t, const vec<S, Eigen::Dynamic>& y, vec<S, Eigen::Dynamic>& f) const {
        base(t, y, f);
    }
    Eigen::SparseMatrix<double> sparsity() const {
        std::vector<Eigen::Triplet<double>> entries;
        base.jacobian_entries(base.initial(), [&](int i, int j, double) { entries.emplace_back(i, j, 1.0); });
        Eigen::SparseMatrix<double> pattern(2 * base.N, 2 * base.N);
        pattern.setFromTriplets(entries.begin(), entries.end());
        return pattern;
    }
    void jacobian(double, const Eigen::VectorXd& y, Eigen::SparseMatrix<double>& J) const {
        base.jacobian_entries(y, [&](int i, int j, double v) { J.coeffRef(i, j) = v; });
    }
};

}  // namespace problems
