// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

// The equations of stiff and constrained test problems, each a right-hand side with its mass and index and nothing else, so
// that a test sees the Jacobian the library makes of it. Solutions at the end of the interval are in data/<name>.json.
namespace equations {

struct van_der_pol {
    double epsilon = 1e-6;
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 2, 1>& y, Eigen::Matrix<S, 2, 1>& f) const {
        f[0] = y[1];
        f[1] = ((1.0 - y[0] * y[0]) * y[1] - y[0]) / epsilon;
    }
};

struct robertson {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 3, 1>& y, Eigen::Matrix<S, 3, 1>& f) const {
        f[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
        f[2] = 3e7 * y[1] * y[1];
        f[1] = -f[0] - f[2];
    }
};

struct oregonator {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 3, 1>& y, Eigen::Matrix<S, 3, 1>& f) const {
        f[0] = 77.27 * (y[1] + y[0] * (1.0 - 8.375e-6 * y[0] - y[1]));
        f[1] = (y[2] - (1.0 + y[0]) * y[1]) / 77.27;
        f[2] = 0.161 * (y[0] - y[2]);
    }
};

struct hires {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 8, 1>& y, Eigen::Matrix<S, 8, 1>& f) const {
        f[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
        f[1] = 1.71 * y[0] - 8.75 * y[1];
        f[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
        f[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
        f[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
        f[5] = -280.0 * y[5] * y[7] + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
        f[6] = 280.0 * y[5] * y[7] - 1.81 * y[6];
        f[7] = -f[6];
    }
};

// Index 1, M of rank 5.
struct transistor_amplifier {
    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, 8, 1>& y, Eigen::Matrix<S, 8, 1>& f) const {
        using std::exp;
        using std::sin;
        const auto g = [](const S& u) -> S { return 1e-6 * (exp(u / 0.026) - 1.0); };
        const S ue = 0.1 * sin(200 * std::numbers::pi * t), g1 = g(y[1] - y[2]), g2 = g(y[4] - y[5]);
        f[0] = (y[0] - ue) / 1000.0;
        f[1] = y[1] / 9000.0 + (y[1] - 6.0) / 9000.0 + 0.01 * g1;
        f[2] = y[2] / 9000.0 - g1;
        f[3] = (y[3] - 6.0) / 9000.0 + 0.99 * g1;
        f[4] = y[4] / 9000.0 + (y[4] - 6.0) / 9000.0 + 0.01 * g2;
        f[5] = y[5] / 9000.0 - g2;
        f[6] = (y[6] - 6.0) / 9000.0 + 0.99 * g2;
        f[7] = y[7] / 9000.0;
    }
    Eigen::Matrix<double, 8, 8> mass() const {
        Eigen::Matrix<double, 8, 8> m = Eigen::Matrix<double, 8, 8>::Zero();
        const auto capacitor = [&m](int i, int j, double c) {
            m(i, i) -= c;
            if (j != i) m(j, j) -= c, m(i, j) += c, m(j, i) += c;
        };
        capacitor(0, 1, 1e-6);
        capacitor(2, 2, 2e-6);
        capacitor(3, 4, 3e-6);
        capacitor(5, 5, 4e-6);
        capacitor(6, 7, 5e-6);
        return m;
    }
};

// REFERENCE: HLR89; solution (e^t, e^-2t, e^2t).
struct index_two {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 3, 1>& y, Eigen::Matrix<S, 3, 1>& f) const {
        f[0] = y[0] * y[1] * y[1] * y[2] * y[2];
        f[1] = y[0] * y[0] * y[1] * y[1] - 3 * y[1] * y[1] * y[2];
        f[2] = y[0] * y[0] * y[1] - 1;
    }
    Eigen::DiagonalMatrix<double, 3> mass() const { return Eigen::DiagonalMatrix<double, 3>(1, 1, 0); }
    std::array<int, 3> index() const { return {1, 1, 2}; }
};

// Jay's problem of index 3: y1 = z1 = e^2t, y2 = z2 = e^-t, u = e^t.
struct index_three {
    template <class S>
    void operator()(const S&, const Eigen::Matrix<S, 5, 1>& x, Eigen::Matrix<S, 5, 1>& f) const {
        const S &y1 = x[0], &y2 = x[1], &z1 = x[2], &z2 = x[3], &u = x[4];
        f[0] = 2 * y1 * y2 * z1 * z2;
        f[1] = -y1 * y2 * z2 * z2;
        f[2] = (y1 * y2 + z1 * z2) * u;
        f[3] = -y1 * y2 * y2 * z2 * z2 * u;
        f[4] = y1 * y2 * y2 - 1;
    }
    Eigen::DiagonalMatrix<double, 5> mass() const {
        Eigen::DiagonalMatrix<double, 5> m;
        m.diagonal() << 1, 1, 1, 1, 0;
        return m;
    }
    std::array<int, 5> index() const { return {1, 1, 2, 2, 3}; }
};

}  // namespace equations
