// SPDX-License-Identifier: BSL-1.0
// Problems that stand for a class of size and structure: kinetics, chains of masses, a spectral method, a
// circuit, a reaction front. Reference solutions are in data/<name>.json.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stagecraft/linear/banded_matrix.hpp>
#include <vector>

#include <problems/stiff.hpp>

namespace problems {

/// rate * y_a * y_b (b = -1: rate * y_a), which consumes a and b and makes the products.
struct reaction {
    double rate;
    int a, b;
    std::vector<int> products;
};

/// Mass-action kinetics of N species: few entries of J are not zero.
template <int N>
struct kinetics {
    static constexpr int size = N;
    std::vector<reaction> reactions;
    vec<double, N> y0;

    vec<double, N> initial() const { return y0; }
    template <class S>
    void operator()(const S&, const vec<S, N>& y, vec<S, N>& f) const {
        f.setZero();
        for (const reaction& r : reactions) {
            S v = r.rate * y[r.a];
            if (r.b >= 0) v *= y[r.b];
            f[r.a] -= v;
            if (r.b >= 0) f[r.b] -= v;
            for (const int p : r.products) f[p] += v;
        }
    }
    void jacobian(double, const vec<double, N>& y, Eigen::Matrix<double, N, N>& J) const {
        J.setZero();
        const auto add = [&](const reaction& r, int by, double slope) {
            J(r.a, by) -= slope;
            if (r.b >= 0) J(r.b, by) -= slope;
            for (const int p : r.products) J(p, by) += slope;
        };
        for (const reaction& r : reactions) {
            add(r, r.a, r.b >= 0 ? r.rate * y[r.b] : r.rate);
            if (r.b >= 0) add(r, r.b, r.rate * y[r.a]);
        }
    }
};

/// The air pollution model of 20 species and 25 reactions (J. G. Verwer, SIAM J. Sci. Comput. 15 (1994)
/// 1243-1250).
struct pollution : kinetics<20> {
    static constexpr const char* name = "pollution";
    static constexpr double t0 = 0, t1 = 60, atol_scale = 1e-3;
    pollution() {
        reactions = {{.35, 0, -1, {1, 2}},       {26.6, 1, 3, {0}},        {1.23e4, 4, 1, {5, 0}},
                     {8.6e-4, 6, -1, {4, 4, 7}}, {8.2e-4, 6, -1, {7}},     {1.5e4, 6, 5, {4, 7}},
                     {1.3e-4, 8, -1, {9, 4, 7}}, {2.4e4, 8, 5, {10}},      {1.65e4, 10, 1, {0, 9, 11}},
                     {9e3, 10, 0, {12}},         {.022, 12, -1, {10, 0}},  {1.2e4, 9, 1, {13, 0}},
                     {1.88, 13, -1, {6, 4}},     {1.63e4, 0, 5, {14}},     {4.8e6, 2, -1, {3}},
                     {3.5e-4, 3, -1, {15}},      {.0175, 3, -1, {2}},      {1e8, 15, -1, {5, 5}},
                     {4.44e11, 15, -1, {2}},     {1.24e3, 16, 5, {17, 4}}, {2.1, 18, -1, {1}},
                     {5.78, 18, -1, {0, 2}},     {.0474, 0, 3, {18}},      {1.78e3, 18, 0, {19}},
                     {3.12, 19, -1, {18, 0}}};
        y0.setZero();
        y0[1] = .2, y0[3] = .04, y0[6] = .1, y0[7] = .3, y0[8] = .01, y0[16] = .007;
    }
};

/// 60 species, 120 reactions a + b -> c + d and a -> c drawn by chance, rates from 1e-3 to 1e6.
struct network : kinetics<Eigen::Dynamic> {
    static constexpr const char* name = "network60";
    static constexpr double t0 = 0, t1 = 10, atol_scale = 1e-4;
    network() {
        std::uint32_t state = 12345;
        const auto below = [&](int n) {
            state = 1664525 * state + 1013904223;
            return static_cast<int>((state >> 8) % static_cast<std::uint32_t>(n));
        };
        for (int k = 0; k < 120; ++k) {
            const double rate = std::pow(10.0, below(9001) / 1000.0 - 3);
            const int a = below(60), b = k % 3 == 0 ? -1 : below(60), c = below(60), d = below(60);
            reactions.push_back(b < 0 ? reaction{rate, a, b, {c}} : reaction{rate, a, b, {c, d}});
        }
        y0.resize(60);
        for (int i = 0; i < 60; ++i) y0[i] = 1.0 / (1 + i);
    }
};

/// N/2 masses in a row, the first one fastened to a wall that shakes, the last one to a wall at rest; stiff
/// springs that harden, dampers between neighbours. N may be known at run time.
template <int N>
struct chain {
    static constexpr const char* name = N == Eigen::Dynamic ? "chain40" : "chain14";
    static constexpr int size = N, second_order_components = N == Eigen::Dynamic ? Eigen::Dynamic : N / 2;
    static constexpr double t0 = 0, t1 = 1, atol_scale = 0.1;
    static constexpr double stiffness = 2e3, hardening = 3e4, damping = 60;
    int masses = N == Eigen::Dynamic ? 40 : N / 2;

    vec<double, N> initial() const { return vec<double, N>::Zero(2 * masses); }
    template <class S>
    void operator()(const S& t, const vec<S, N>& y, vec<S, N>& f) const {
        using std::cos;
        using std::sin;
        const int m = masses;
        S force = S(0.0);  // of the spring on the left
        for (int i = 0; i <= m; ++i) {
            const S q = i < m ? S(y[i]) : S(0.0), v = i < m ? S(y[m + i]) : S(0.0);
            const S before = i > 0 ? S(y[i - 1]) : S(0.3 * sin(7.0 * t)),
                    speed = i > 0 ? S(y[m + i - 1]) : S(2.1 * cos(7.0 * t));
            const S d = q - before;
            const S pull = (1 + i % 3) * stiffness * d + hardening * d * d * d + damping * (v - speed);
            if (i > 0) f[m + i - 1] = pull - force;
            force = pull;
        }
        for (int i = 0; i < m; ++i) f[i] = y[m + i];
    }
    void jacobian(double t, const vec<double, N>& y, Eigen::Matrix<double, N, N>& J) const {
        const int m = masses;
        J.setZero();
        for (int i = 0; i < m; ++i) J(i, m + i) = 1;
        for (int i = 0; i <= m; ++i) {
            const double d = (i < m ? y[i] : 0.0) - (i > 0 ? y[i - 1] : 0.3 * std::sin(7 * t));
            const double slope = (1 + i % 3) * stiffness + 3 * hardening * d * d;
            for (const int row : {i - 1, i})
                for (const int column : {i - 1, i})
                    if (row >= 0 && row < m && column >= 0 && column < m) {
                        const double sign = row == column ? -1 : 1;
                        J(m + row, column) += sign * slope;
                        J(m + row, m + column) += sign * damping;
                    }
        }
    }
};

/// u_t = 0.01 u_xx + u - u^3 on [-1, 1], u(-1) = -1, u(1) = 1, by Chebyshev collocation at n inner points (L.
/// N. Trefethen, Spectral Methods in MATLAB, SIAM 2000, program 34): J is full, its norm grows as n^4.
template <int N>
struct allen_cahn {
    static constexpr const char* name = N == Eigen::Dynamic ? "spectral64" : "spectral24";
    static constexpr int size = N;
    static constexpr double t0 = 0, t1 = 20, atol_scale = 1;
    using matrix = Eigen::Matrix<double, N, N>;
    int n = N == Eigen::Dynamic ? 64 : N;
    matrix diffusion;
    vec<double, N> x, boundary;

    allen_cahn() {
        const int last = n + 1;
        Eigen::VectorXd nodes(last + 1);
        for (int i = 0; i <= last; ++i) nodes[i] = std::cos(std::numbers::pi * i / last);
        const auto weight = [&](int i) { return (i % 2 == 0 ? 1.0 : -1.0) * (i == 0 || i == last ? 2 : 1); };
        Eigen::MatrixXd D = Eigen::MatrixXd::Zero(last + 1, last + 1);
        for (int i = 0; i <= last; ++i)
            for (int j = 0; j <= last; ++j)
                if (i != j) {
                    D(i, j) = weight(i) / (weight(j) * (nodes[i] - nodes[j]));
                    D(i, i) -= D(i, j);
                }
        const Eigen::MatrixXd D2 = 0.01 * (D * D);
        diffusion = D2.block(1, 1, n, n);
        boundary = D2.col(0).segment(1, n) - D2.col(last).segment(1, n);
        x = nodes.segment(1, n);
    }
    vec<double, N> initial() const {
        return 0.53 * x.array() + 0.47 * (-1.5 * std::numbers::pi * x.array()).sin();
    }
    template <class S>
    void operator()(const S&, const vec<S, N>& y, vec<S, N>& f) const {
        f.noalias() = diffusion * y;
        f += boundary;
        f.array() += y.array() - y.array() * y.array() * y.array();
    }
    void jacobian(double, const vec<double, N>& y, matrix& J) const {
        J = diffusion;
        J.diagonal().array() += 1 - 3 * y.array() * y.array();
    }
};

/// A ladder of ten capacitors fed with an alternating voltage through resistors and diodes; the nodes between
/// a resistor and its diode have no capacitor: an index-1 DAE of 20 unknowns.
struct diode_ladder {
    static constexpr const char* name = "diodes20";
    static constexpr int size = 20;
    static constexpr double t0 = 0, t1 = 0.05, atol_scale = 1;
    static constexpr double R = 1e3, leak = 1e5, C = 1e-7, UF = 0.052, saturation = 1e-7;
    static vec<double, size> initial() { return vec<double, size>::Zero(); }

    template <class S>
    void operator()(const S& t, const vec<S, size>& y, vec<S, size>& f) const {
        using std::exp;
        using std::sin;
        S current = (2.0 * sin(200 * std::numbers::pi * t) - y[0]) / R;  // into the node
        for (int i = 0; i < size; i += 2) {
            const S to_diode = (y[i] - y[i + 1]) / R;
            f[i] = current - to_diode - y[i] / leak;
            const S next = i + 2 < size ? S(y[i + 2]) : S(0.0);
            current = saturation * (exp((y[i + 1] - next) / UF) - 1.0);
            f[i + 1] = to_diode - current;
        }
    }
    void jacobian(double, const vec<double, size>& y, Eigen::Matrix<double, size, size>& J) const {
        J.setZero();
        J(0, 0) = -1 / R;
        for (int i = 0; i < size; i += 2) {
            J(i, i) -= 1 / R + 1 / leak, J(i, i + 1) = 1 / R;
            J(i + 1, i) = 1 / R, J(i + 1, i + 1) = -1 / R;
            const double next = i + 2 < size ? y[i + 2] : 0.0;
            const double d = saturation / UF * std::exp((y[i + 1] - next) / UF);
            J(i + 1, i + 1) -= d;
            if (i + 2 < size) J(i + 1, i + 2) = d, J(i + 2, i + 1) = d, J(i + 2, i + 2) = -d;
        }
    }
    Eigen::Matrix<double, size, size> mass() const {
        Eigen::Matrix<double, size, size> M = Eigen::Matrix<double, size, size>::Zero();
        for (int i = 0; i < size; i += 2) M(i, i) = C;
        return M;
    }
};

/// The Brusselator on 100 points, n = 200.
struct brusselator200 : brusselator {
    static constexpr const char* name = "bruss200";
    brusselator200() { N = 100; }
};

/// A front u_t = u_xx / 500 + 40 u^2 (1 - u) that crosses 400 points, no flux at the ends: J is tridiagonal.
struct front {
    static constexpr const char* name = "front400";
    static constexpr int size = Eigen::Dynamic, lower = 1, upper = 1;
    static constexpr double t0 = 0, t1 = 2, atol_scale = 1;
    int n = 400;

    double diffusion() const { return (n - 1.0) * (n - 1.0) / 500; }
    Eigen::VectorXd initial() const {
        return Eigen::VectorXd::NullaryExpr(n, [this](Eigen::Index i) {
            return 1 / (1 + std::exp(100 * (static_cast<double>(i) / (n - 1) - 0.2)));
        });
    }
    template <class S>
    void operator()(const S&, const vec<S, Eigen::Dynamic>& y, vec<S, Eigen::Dynamic>& f) const {
        const double d = diffusion();
        for (int i = 0; i < n; ++i) {
            const S &u = y[i], &l = y[i > 0 ? i - 1 : 1], &r = y[i + 1 < n ? i + 1 : n - 2];
            f[i] = d * (l - 2.0 * u + r) + 40.0 * u * u * (1.0 - u);
        }
    }
    stagecraft::bandwidth bandwidth() const { return {lower, upper}; }
    void jacobian(double, const Eigen::VectorXd& y, stagecraft::banded_matrix<double>& J) const {
        jacobian_entries(y, [&](int i, int j, double v) { J(i, j) = v; });
    }
    template <class Entry>
    void jacobian_entries(const Eigen::VectorXd& y, Entry entry) const {
        const double d = diffusion();
        for (int i = 0; i < n; ++i) {
            entry(i, i, -2 * d + 80 * y[i] - 120 * y[i] * y[i]);
            if (i > 0) entry(i, i - 1, i + 1 < n ? d : 2 * d);
            if (i + 1 < n) entry(i, i + 1, i > 0 ? d : 2 * d);
        }
    }
};

}  // namespace problems
