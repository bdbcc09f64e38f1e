// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace thesis {

/// A knife edge (a skate) on a plane that falls in x direction with slope `fall` = g sin(incline) [m/s^2]:
/// q = (x, y, phi), no motion across the blade. From rest with phi' = omega it moves on a cycloid,
/// x = fall/(2 omega^2) sin^2(omega t), y = fall/(2 omega^2) (omega t - sin(2 omega t)/2) (Bloch,
/// Nonholonomic Mechanics and Control, 1.6).
struct knife_edge {
    static constexpr int coordinates = 3, constraints = 1;
    double mass = 1, inertia = 0.5, fall = 4.905;

    template <class S>
    Eigen::Matrix<S, 3, 3> M(const Eigen::Matrix<S, 3, 1>&) const {
        Eigen::Matrix<S, 3, 3> M = Eigen::Matrix<S, 3, 3>::Constant(S(0));
        M(0, 0) = M(1, 1) = S(mass);
        M(2, 2) = S(inertia);
        return M;
    }
    template <class S>
    Eigen::Matrix<S, 3, 1> F(const Eigen::Matrix<S, 3, 1>&, const Eigen::Matrix<S, 3, 1>&) const {
        return Eigen::Matrix<S, 3, 1>(S(mass * fall), S(0), S(0));
    }
    template <class S>
    Eigen::Matrix<S, 1, 3> G(const Eigen::Matrix<S, 3, 1>& q) const {
        using std::cos;
        using std::sin;
        return Eigen::Matrix<S, 1, 3>(S(sin(q[2])), S(-cos(q[2])), S(0));
    }
    template <class S>
    S potential(const Eigen::Matrix<S, 3, 1>& q) const {
        return S(-mass * fall) * q[0];
    }
};

/// Chaplygin's sleigh: a rigid body on a horizontal plane that slides on a blade a distance `a` behind its
/// centre of mass; q = (x, y, theta) of the blade. It coasts into straight motion although its energy is
/// constant.
struct chaplygin_sleigh {
    static constexpr int coordinates = 3, constraints = 1;
    double mass = 1, inertia = 0.5, a = 0.4;

    template <class S>
    Eigen::Matrix<S, 3, 3> M(const Eigen::Matrix<S, 3, 1>& q) const {
        using std::cos;
        using std::sin;
        Eigen::Matrix<S, 3, 3> M = Eigen::Matrix<S, 3, 3>::Constant(S(0));
        M(0, 0) = M(1, 1) = S(mass);
        M(0, 2) = M(2, 0) = S(-mass * a) * S(sin(q[2]));
        M(1, 2) = M(2, 1) = S(mass * a) * S(cos(q[2]));
        M(2, 2) = S(inertia + mass * a * a);
        return M;
    }
    template <class S>
    Eigen::Matrix<S, 3, 1> F(const Eigen::Matrix<S, 3, 1>& q, const Eigen::Matrix<S, 3, 1>& v) const {
        using std::cos;
        using std::sin;
        const S centrifugal = S(mass * a) * v[2] * v[2];
        return Eigen::Matrix<S, 3, 1>(S(centrifugal * S(cos(q[2]))), S(centrifugal * S(sin(q[2]))), S(0));
    }
    template <class S>
    Eigen::Matrix<S, 1, 3> G(const Eigen::Matrix<S, 3, 1>& q) const {
        using std::cos;
        using std::sin;
        return Eigen::Matrix<S, 1, 3>(S(sin(q[2])), S(-cos(q[2])), S(0));
    }
    template <class S>
    S potential(const Eigen::Matrix<S, 3, 1>&) const {
        return S(0);
    }
};

/// A pendulum of length 1 in Cartesian coordinates, 0 = (x^2 + y^2 - 1)/2: the holonomic standard example.
struct pendulum {
    static constexpr int coordinates = 2, constraints = 1;
    double gravity = 9.81;

    template <class S>
    Eigen::Matrix<S, 2, 2> M(const Eigen::Matrix<S, 2, 1>&) const {
        Eigen::Matrix<S, 2, 2> M = Eigen::Matrix<S, 2, 2>::Constant(S(0));
        M(0, 0) = M(1, 1) = S(1);
        return M;
    }
    template <class S>
    Eigen::Matrix<S, 2, 1> F(const Eigen::Matrix<S, 2, 1>&, const Eigen::Matrix<S, 2, 1>&) const {
        return Eigen::Matrix<S, 2, 1>(S(0), S(-gravity));
    }
    template <class S>
    Eigen::Matrix<S, 1, 2> G(const Eigen::Matrix<S, 2, 1>& q) const {
        return Eigen::Matrix<S, 1, 2>(q[0], q[1]);
    }
    template <class S>
    Eigen::Matrix<S, 1, 1> g(const Eigen::Matrix<S, 2, 1>& q) const {
        return Eigen::Matrix<S, 1, 1>(S((q[0] * q[0] + q[1] * q[1] - S(1)) / S(2)));
    }
    template <class S>
    S potential(const Eigen::Matrix<S, 2, 1>& q) const {
        return S(gravity) * q[1];
    }
};

}  // namespace thesis
