// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include <stagecraft/mechanics/model.hpp>

namespace rolling_disc {

/// A thin homogeneous disc that rolls without slip on a horizontal plane (B. Braun, diploma thesis
/// 2013, 4.1.1). Coordinates q = (x, y, alpha, beta, gamma): contact point (x, y) [m] in the frame turned by
/// the heading alpha, leaning angle beta (0 upright, +-pi/2 flat), rolling angle gamma [rad]. Radius R [m],
/// mass m [kg], g [m/s^2].
///
/// The thesis prints -4 alpha' y' in F_3 and F_4 where -4 alpha' y belongs; `printed_force` selects the
/// misprint, which the energy finds out.
template <class Real = double>
struct disc {
    static constexpr int coordinates = 5, constraints = 2;
    static constexpr const char* singular_position = "beta = +-pi/2: the disc lies flat";

    Real R = Real(1) / Real(10), m = Real(1), g = Real(981) / Real(100);
    bool printed_force = false;

    template <class S>
    using vector = Eigen::Matrix<S, 5, 1>;

    template <class S>
    Eigen::Matrix<S, 5, 5> M(const vector<S>& q) const {
        using std::cos;
        using std::sin;
        const S r = S(R), mass = S(m), x = q[0], y = q[1], s = sin(q[3]), c = cos(q[3]);
        const S rs = r * s, rc = r * c, rr = r * r;
        Eigen::Matrix<S, 5, 5> M = Eigen::Matrix<S, 5, 5>::Constant(S(0));
        M(0, 0) = mass;
        M(1, 1) = mass;
        M(2, 0) = mass * (rs - y);
        M(2, 1) = mass * x;
        M(2, 2) = mass * (x * x + y * y - rc * rc * S(5) / S(4) + rr * S(3) / S(2) - rs * y * S(2));
        M(3, 1) = -mass * rc;
        M(3, 2) = -mass * x * rc;
        M(3, 3) = mass * rr * S(5) / S(4);
        M(4, 2) = mass * r * rs / S(2);
        M(4, 4) = mass * rr / S(2);
        for (int i = 0; i < 5; ++i)
            for (int j = i + 1; j < 5; ++j) M(i, j) = M(j, i);
        return M;
    }

    template <class S>
    vector<S> F(const vector<S>& q, const vector<S>& v) const {
        using std::cos;
        using std::sin;
        const S r = S(R), mass = S(m), x = q[0], y = q[1], s = sin(q[3]), c = cos(q[3]);
        const S dx = v[0], dy = v[1], da = v[2], db = v[3], dc = v[4];
        const S lever = printed_force ? dy : y;
        vector<S> F;
        F[0] = mass * da * (dy * S(2) - db * r * c * S(2) + da * x);
        F[1] = mass * (da * da * y - r * (da * da + db * db) * s - da * dx * S(2));
        F[2] = mass * (r * (da * dy * S(2) - db * db * x) * s - da * (x * dx + y * dy) * S(2) -
                       (s * da * r * S(5) + r * dc - da * lever * S(4)) * db * r * c / S(2));
        F[3] =
            mass * r *
            ((s * da * r * S(5) - da * lever * S(4) + dx * S(8) + r * dc * S(2)) * da * c / S(4) + S(g) * s);
        F[4] = -mass * r * r * da * c * db / S(2);
        return F;
    }

    /// G(q) q' = 0: the contact point moves as the rim unrolls, x' = R gamma' + y alpha', y' = -x alpha'.
    template <class S>
    Eigen::Matrix<S, 2, 5> G(const vector<S>& q) const {
        Eigen::Matrix<S, 2, 5> G = Eigen::Matrix<S, 2, 5>::Constant(S(0));
        G(0, 0) = S(1);
        G(0, 2) = -q[1];
        G(0, 4) = S(-R);
        G(1, 1) = S(1);
        G(1, 2) = q[0];
        return G;
    }

    /// dG/dt along q' = v.
    template <class S>
    Eigen::Matrix<S, 2, 5> G_rate(const vector<S>&, const vector<S>& v) const {
        Eigen::Matrix<S, 2, 5> rate = Eigen::Matrix<S, 2, 5>::Constant(S(0));
        rate(0, 2) = -v[1];
        rate(1, 2) = v[0];
        return rate;
    }

    /// M(q)^-1 r, by elimination with paper and pencil.
    template <class S>
    vector<S> solve_mass(const vector<S>& q, const vector<S>& rhs) const {
        using std::cos;
        using std::sin;
        const S r = S(R), mass = S(m), x = q[0], s = sin(q[3]), c = cos(q[3]);
        const S arm = r * s - q[1], rr = r * r, cc = c * c;
        vector<S> a;
        a[2] = S(4) * (rhs[2] - arm * rhs[0] - x * rhs[1] - s * rhs[4]) / (mass * rr * cc);
        a[3] = (rhs[3] + c * r * rhs[1]) / (mass * rr * (S(5) / S(4) - cc));
        a[0] = rhs[0] / mass - arm * a[2];
        a[1] = rhs[1] / mass - x * a[2] + c * r * a[3];
        a[4] = S(2) * rhs[4] / (mass * rr) - s * a[2];
        return a;
    }

    template <class S>
    S potential(const vector<S>& q) const {
        using std::cos;
        return S(m) * S(g) * S(R) * cos(q[3]);
    }

    /// cos(beta): its square is det M(q) up to factors that stay away from zero.
    template <class S>
    S singularity(const vector<S>& q) const {
        using std::cos;
        return cos(q[3]);
    }
};

/// The motion of the thesis: leaning by 5 degrees, rolling half a turn per second.
template <class Real = double>
Eigen::Matrix<Real, 5, 1> initial_position() {
    using std::acos;
    Eigen::Matrix<Real, 5, 1> q = Eigen::Matrix<Real, 5, 1>::Constant(Real(0));
    q[3] = acos(Real(-1)) / Real(36);
    return q;
}
template <class Real = double>
Eigen::Matrix<Real, 5, 1> initial_velocity(const disc<Real>& body = {}) {
    using std::acos;
    Eigen::Matrix<Real, 5, 1> v = Eigen::Matrix<Real, 5, 1>::Constant(Real(0));
    v[4] = acos(Real(-1));
    v[0] = body.R * v[4];
    return v;
}

}  // namespace rolling_disc
