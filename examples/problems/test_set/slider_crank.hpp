// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

namespace problems::test_set {

/// A slider crank whose connecting rod bends and stretches, driven at a constant rate, without damping (problem "crank" of
/// Mazzia-Magherini 2008; Simeon 1996). M y' = f, n = 24: positions p = (crank angle, rod angle, slider, two coefficients of
/// bending, two of stretching), velocities v, accelerations w and multipliers lambda, the last two of index 2.
///
/// The values are those of newer ports of the program, whose pi has eight digits; older ones in circulation (phi_2 = -0.3311734987910881)
/// belong to pi in full and to a start with fewer digits, which violates a constraint by 1e-8.
///
///     p' = v,   v' = w,   0 = M(p) w - F(p, v) + G(p)^T lambda,   0 = G(p) v - (0, 0, omega)
struct slider_crank {
    static constexpr const char* name = "crank";
    static constexpr double t0 = 0, t1 = 0.1;
    static constexpr double m2 = 0.151104, m3 = 0.075552, l1 = 0.15, l2 = 0.3, J1 = 0.002727,
                            J2 = 0.0045339259, pi = 3.1415927, young = 0.2e12, width = 0.008, density = 7870,
                            omega = 150;
    static constexpr int coordinates = 7, elastic = 4;
    using constants = std::array<double, elastic>;
    using matrix = std::array<constants, elastic>;

    /// Integrals over the rod: of its mass, stiffness and gyroscopic coupling, and of the shapes.
    static constexpr double volume = width * width * l2, mass2 = density * volume,
                            slender = width / l2 * (width / l2), stiff = young * width * width / l2,
                            pi2 = pi * pi, twist = 8 / (pi * pi2);
    static constexpr matrix inertia{
        {{mass2 / 2}, {0, mass2 / 2}, {0, 0, 8 * mass2, mass2}, {0, 0, mass2, 2 * mass2}}};
    static constexpr matrix stiffness{{{stiff * pi2 * pi2 / 24 * slender},
                                       {0, stiff* pi2* pi2 * 2 / 3 * slender},
                                       {0, 0, stiff * 16 / 3, -stiff * 8 / 3},
                                       {0, 0, -stiff * 8 / 3, stiff * 7 / 3}}};
    static constexpr double b13 = -2 * twist * volume, b14 = (twist - 1 / pi) * volume,
                            b24 = volume / (2 * pi);
    static constexpr matrix coupling{{{0, 0, b13, b14}, {0, 0, 0, b24}, {-b13}, {-b14, -b24}}};
    static constexpr constants c1{0, 0, volume * 2 / 3, volume / 6}, c2{volume * 2 / pi},
        c12{0, 0, l2*volume / 3, l2*volume / 6}, c21{l2 * volume / pi, -l2*volume / (2 * pi)};

    template <class S>
    using shapes = std::array<S, elastic>;
    template <class A, class S>
    static S dot(const A& a, const shapes<S>& b) {
        S sum(0.0);
        for (int i = 0; i < elastic; ++i) sum += a[i] * b[i];
        return sum;
    }
    template <class S>
    static shapes<S> times(const matrix& A, const shapes<S>& q) {
        return {dot(A[0], q), dot(A[1], q), dot(A[2], q), dot(A[3], q)};
    }

    template <class Y, class F>
    void operator()(double, const Y& y, F& f) const {
        using S = typename Y::Scalar;
        using std::cos, std::sin;
        constexpr int n = coordinates;
        const auto v = [&](int i) -> const S& { return y[n + i]; };
        const auto w = [&](int i) -> const S& { return y[2 * n + i]; };
        const shapes<S> q{y[3], y[4], y[5], y[6]}, dq{v(3), v(4), v(5), v(6)}, ddq{w(3), w(4), w(5), w(6)};
        const S s = sin(S(y[0] - y[1])), c = cos(S(y[0] - y[1]));
        const shapes<S> Mq = times(inertia, q), Kq = times(stiffness, q), Bq = times(coupling, q),
                        Bdq = times(coupling, dq), Mddq = times(inertia, ddq);
        const S along = dot(c1, q), across = dot(c2, q);

        for (int i = 0; i < 2 * n; ++i) f[i] = y[n + i];
        // M w - F. The coupling is antisymmetric: q^T B = -(B q)^T.
        S* const r = &f[2 * n];
        const S arm = 0.5 * l1 * l2 * m2, m12 = arm * c + density * l1 * (s * across + c * along),
                turning = arm * s + density * l1 * (s * along - c * across);
        r[0] = (J1 + m2 * l1 * l1) * w(0) + m12 * w(1) + v(1) * v(1) * turning +
               density * l1 * (c * dot(c2, ddq) - s * dot(c1, ddq)) +
               2 * density * l1 * v(1) * (c * dot(c1, dq) + s * dot(c2, dq));
        r[1] = m12 * w(0) + (J2 + dot(q, Mq) + 2 * density * dot(c12, q)) * w(1) +
               density * (dot(c21, ddq) - dot(Bq, ddq)) - v(0) * v(0) * turning +
               2 * v(1) * (density * dot(c12, dq) + dot(dq, Mq)) + density * dot(dq, Bdq);
        r[2] = m3 * w(2);
        for (int i = 0; i < elastic; ++i)
            r[3 + i] = density * l1 * (c * c2[i] - s * c1[i]) * w(0) + density * (c21[i] - Bq[i]) * w(1) +
                       Mddq[i] - v(1) * v(1) * (Mq[i] + density * c12[i]) -
                       density * (l1 * v(0) * v(0) * (c * c1[i] + s * c2[i]) + 2 * v(1) * Bdq[i]) + Kq[i];
        constrain(y, f);
    }
    /// Adds G^T lambda, and writes G v - (0, 0, omega).
    template <class Y, class F>
    static void constrain(const Y& y, F& f) {
        using S = typename Y::Scalar;
        using std::cos, std::sin;
        constexpr int n = coordinates;
        const S sine = sin(y[1]), cosine = cos(y[1]), rod = l2 + y[6];
        const std::array<S, 3> lambda{y[3 * n], y[3 * n + 1], y[3 * n + 2]};
        const auto entry = [&](int row, int i, const S& g) {
            f[2 * n + i] += g * lambda[row];
            f[3 * n + row] += g * y[n + i];
        };
        for (int k = 0; k < 3; ++k) f[3 * n + k] = S(k < 2 ? 0.0 : -omega);
        entry(0, 0, l1 * cos(y[0]));
        entry(0, 1, rod * cosine);
        entry(0, 6, sine);
        entry(1, 0, l1 * sin(y[0]));
        entry(1, 1, rod * sine);
        entry(1, 2, S(1.0));
        entry(1, 6, S(-cosine));
        entry(2, 0, S(1.0));
    }
    Eigen::MatrixXd mass() const {
        Eigen::VectorXd m = Eigen::VectorXd::Zero(24);
        m.head(14).setOnes();
        return m.asDiagonal().toDenseMatrix();
    }
    std::vector<int> index() const {
        std::vector<int> flags(14, 1);
        flags.resize(24, 2);
        return flags;
    }
    /// Close to the smooth motion; all constraints hold, those of the positions to 2e-10.
    Eigen::VectorXd initial() const {
        Eigen::VectorXd y(24);
        y << 0, 0, 0.450016933, 0, 0, 1.03339863e-5, 1.69327969e-5, 150, -74.99576703969453,
            -2.689386719979040e-6, 0.4448961125815990, 4.634339319238670e-3, -1.785910760000550e-6,
            -2.689386719979040e-6, 0, -1.344541576709835e-3, -5062.194924490193, -6.829725665986310e-5,
            1.813207639590617e-20, -4.268463266810281, 0.2098339029337557, -6.552727150584648e-8,
            382.4589509350831, -4.635908708561371e-9;
        return y;
    }
    /// The published values at t1.
    Eigen::VectorXd reference() const {
        Eigen::VectorXd y(24);
        y << 15, -0.3311734988256260, 0.1697373328427860, 1.893192899613509e-4, 2.375751249879174e-5,
            -5.323896770569702e-6, -8.363313279112129e-6, 150, 60.25346755138369, -8.753116326670527,
            -3.005541400289738e-2, -5.500431812571696e-3, 4.974111734266989e-4, 1.105560003626645e-3, 0,
            6488.737541276957, 2167.938629509884, 33.91137060286523, 0.1715134772216488, -1.422449408912512,
            1.003946428124810, -62.32935833287916, -163.7920993367306, 25.29857947066878;
        return y;
    }
};

}  // namespace problems::test_set
