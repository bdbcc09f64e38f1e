// SPDX-License-Identifier: BSL-1.0
// Problems in two parts: `slow` is treated explicitly, `fast` implicitly. Each has its name, its interval, its start, both parts,
// and what the linear algebra of the fast part is to know.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cmath>
#include <vector>

namespace split_problems {

using Eigen::Vector2d;
using Eigen::VectorXd;
using triplets = std::vector<Eigen::Triplet<double>>;

inline Eigen::SparseMatrix<double> assembled(int n, const triplets& entries) {
    Eigen::SparseMatrix<double> J(n, n);
    J.setFromTriplets(entries.begin(), entries.end());
    return J;
}

/// Kaps' problem: y = (e^-2t, e^-t) for every eps (Dekker and Verwer 1984).
struct kaps {
    static constexpr const char* name = "kaps";
    static constexpr double t1 = 1, eps = 1e-3;
    using state = Vector2d;
    state initial() const { return {1, 1}; }
    void slow(double, const state& y, state& f) const { f << -2 * y[0], y[0] - y[1] - y[1] * y[1]; }
    void fast(double, const state& y, state& f) const { f << (y[1] * y[1] - y[0]) / eps, 0; }
    void jacobian(const state& y, Eigen::Matrix2d& J) const { J << -1 / eps, 2 * y[1] / eps, 0, 0; }
};

/// Van der Pol's oscillator with the stiff component implicit (Hairer-Wanner II.IV.10), on its slow branch.
struct van_der_pol {
    static constexpr const char* name = "vdpol-split";
    static constexpr double t1 = 0.5, eps = 1e-3;
    using state = Vector2d;
    state initial() const { return {2, -0.6666654321121172}; }
    void slow(double, const state& y, state& f) const { f << y[1], 0; }
    void fast(double, const state& y, state& f) const { f << 0, ((1 - y[0] * y[0]) * y[1] - y[0]) / eps; }
    void jacobian(const state& y, Eigen::Matrix2d& J) const {
        J << 0, 0, (-2 * y[0] * y[1] - 1) / eps, (1 - y[0] * y[0]) / eps;
    }
};

/// The Brusselator in one dimension (Hairer-Wanner II.IV.10): diffusion implicit, reaction explicit.
struct brusselator_1d {
    static constexpr const char* name = "bruss-split";
    static constexpr int cells = 500, lower = 2, upper = 2;
    static constexpr double t1 = 2, dx = 1.0 / (cells + 1), alpha = 0.02 / (dx * dx);
    using state = VectorXd;
    state initial() const {
        state y(2 * cells);
        for (int i = 0; i < cells; ++i) y[2 * i] = 1 + std::sin(2 * M_PI * (i + 1) * dx), y[2 * i + 1] = 3;
        return y;
    }
    void slow(double, const state& y, state& f) const {
        for (int i = 0; i < 2 * cells; i += 2) {
            const double u = y[i], uuv = u * u * y[i + 1];
            f[i] = 1 + uuv - 4 * u, f[i + 1] = 3 * u - uuv;
        }
    }
    void fast(double, const state& y, state& f) const {
        const int n = 2 * cells;
        for (int i = 0; i < n; ++i) {
            const double end = i % 2 == 0 ? 1 : 3;
            f[i] = alpha * ((i < 2 ? end : y[i - 2]) - 2 * y[i] + (i >= n - 2 ? end : y[i + 2]));
        }
    }
    Eigen::SparseMatrix<double> matrix() const {
        triplets entries;
        for (int i = 0; i < 2 * cells; ++i)
            for (int j = i - 2; j <= i + 2; j += 2)
                if (0 <= j && j < 2 * cells) entries.emplace_back(i, j, i == j ? -2 * alpha : alpha);
        return assembled(2 * cells, entries);
    }
};

/// Advection explicit, a stiff linear reaction implicit (Hundsdorfer and Verwer 2003, IV.1.2): u_t + u_x = -k1 u + k2 v,
/// v_t = k1 u - k2 v + 1, u(0, t) = 1 - sin(12 t)^4; fourth-order differences in space.
struct advection_reaction {
    static constexpr const char* name = "advection-reaction";
    static constexpr int cells = 400, lower = 1, upper = 1;
    static constexpr double t1 = 1, dx = 1.0 / cells, k1 = 1e6, k2 = 2 * k1;
    using state = VectorXd;
    state initial() const {
        state y(2 * cells);
        for (int i = 0; i < cells; ++i) {
            const double x = (i + 1) * dx, u = 1 + x;
            y[2 * i] = u, y[2 * i + 1] = k1 / k2 * u + 1 / k2;
        }
        return y;
    }
    void slow(double t, const state& y, state& f) const {
        const double left = 1 - std::pow(std::sin(12 * t), 4);
        const auto u = [&](int i) { return i < 0 ? left : y[2 * i]; };
        for (int i = 0; i < cells; ++i) {
            const double slope = i < 2 || i == cells - 1
                                     ? (u(i) - u(i - 1)) / dx
                                     : (u(i - 2) - 6 * u(i - 1) + 3 * u(i) + 2 * u(i + 1)) / (6 * dx);
            f[2 * i] = -slope, f[2 * i + 1] = 1;
        }
    }
    void fast(double, const state& y, state& f) const {
        for (int i = 0; i < 2 * cells; i += 2) {
            const double turnover = -k1 * y[i] + k2 * y[i + 1];
            f[i] = turnover, f[i + 1] = -turnover;
        }
    }
    Eigen::SparseMatrix<double> matrix() const {
        triplets entries;
        for (int i = 0; i < 2 * cells; i += 2)
            for (int row = 0; row < 2; ++row) {
                const double sign = row == 0 ? 1 : -1;
                entries.emplace_back(i + row, i, -sign * k1);
                entries.emplace_back(i + row, i + 1, sign * k2);
            }
        return assembled(2 * cells, entries);
    }
};

/// Two species on a grid of m x m cells, whose diffusion is implicit; u and v of a cell stand after each other.
struct on_a_square {
    static constexpr int m = 32, n = 2 * m * m;
    static constexpr bool klu = true;
    using state = VectorXd;

    /// Neighbours of cell (i, j): across the border the cell itself (no flux), or the other side where `periodic`.
    template <class Visit>
    static void neighbours(int i, int j, bool periodic, const Visit& visit) {
        const int steps[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
        for (const auto& step : steps) {
            int k = i + step[0], l = j + step[1];
            if (periodic) k = (k + m) % m, l = (l + m) % m;
            if (0 <= k && k < m && 0 <= l && l < m) visit(2 * (k + m * l));
        }
    }
    static void diffuse(const state& y, state& f, double of_u, double of_v, bool periodic) {
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i) {
                const int at = 2 * (i + m * j);
                f[at] = f[at + 1] = 0;
                neighbours(i, j, periodic, [&](int other) {
                    f[at] += of_u * (y[other] - y[at]), f[at + 1] += of_v * (y[other + 1] - y[at + 1]);
                });
            }
    }
    static Eigen::SparseMatrix<double> laplacian(double of_u, double of_v, bool periodic) {
        triplets entries;
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i)
                neighbours(i, j, periodic, [&](int other) {
                    for (int k = 0; k < 2; ++k) {
                        const int at = 2 * (i + m * j) + k;
                        const double d = k == 0 ? of_u : of_v;
                        entries.emplace_back(at, other + k, d), entries.emplace_back(at, at, -d);
                    }
                });
        return assembled(n, entries);
    }
};

/// The Brusselator in two dimensions without flux (Hairer-Norsett-Wanner I.II.10), alpha = 0.1.
struct brusselator_square : on_a_square {
    static constexpr const char* name = "bruss-2d-split";
    static constexpr double t1 = 2, d = 0.1 * (m - 1) * (m - 1);
    state initial() const {
        state y(n);
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i)
                y[2 * (i + m * j)] = 0.5 + j / (m - 1.0), y[2 * (i + m * j) + 1] = 1 + 5 * i / (m - 1.0);
        return y;
    }
    void slow(double, const state& y, state& f) const {
        for (int i = 0; i < n; i += 2) {
            const double u = y[i], uuv = u * u * y[i + 1];
            f[i] = 1 + uuv - 4.4 * u, f[i + 1] = 3.4 * u - uuv;
        }
    }
    void fast(double, const state& y, state& f) const { diffuse(y, f, d, d, false); }
    Eigen::SparseMatrix<double> matrix() const { return laplacian(d, d, false); }
};

/// Gray and Scott's reaction (Pearson 1993: F = 0.024, k = 0.06, D = 2e-5 and 1e-5) on a periodic square of side 0.6.
struct gray_scott : on_a_square {
    static constexpr const char* name = "gray-scott";
    static constexpr double t1 = 200, dx = 0.6 / m, du = 2e-5 / (dx * dx), dv = 1e-5 / (dx * dx);
    state initial() const {
        state y(n);
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i) {
                const double hill =
                    std::exp(-80 * (std::pow((i + 0.5) / m - 0.5, 2) + std::pow((j + 0.5) / m - 0.4, 2)));
                y[2 * (i + m * j)] = 1 - hill / 2, y[2 * (i + m * j) + 1] = hill / 4;
            }
        return y;
    }
    void slow(double, const state& y, state& f) const {
        for (int i = 0; i < n; i += 2) {
            const double u = y[i], v = y[i + 1], uvv = u * v * v;
            f[i] = -uvv + 0.024 * (1 - u), f[i + 1] = uvv - 0.084 * v;
        }
    }
    void fast(double, const state& y, state& f) const { diffuse(y, f, du, dv, true); }
    Eigen::SparseMatrix<double> matrix() const { return laplacian(du, dv, true); }
};

}  // namespace split_problems
