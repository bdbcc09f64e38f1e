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

/// A ball of radius r that rolls without slip inside an upright cylinder, its centre at distance `rho` from
/// the axis: q = (chi, z, phi, theta, psi), the centre's angle around the axis and height and the ball's
/// z-x-z Euler angles. It does not fall: its height oscillates with sqrt(I/(I + m r^2)) = sqrt(2/7) times the
/// rate at which it circles (Routh; the golfer's dilemma).
struct rolling_ball {
    static constexpr int coordinates = 5, constraints = 2;
    static constexpr const char* singular_position = "theta = 0 or pi: phi and psi turn about the same axis";
    double mass = 1, radius = 0.2, rho = 0.3, gravity = 9.81;
    double inertia = 0.4 * mass * radius * radius;  // homogeneous; a hollow one has 2/3

    template <class S>
    using vector = Eigen::Matrix<S, 5, 1>;

    template <class S>
    Eigen::Matrix<S, 5, 5> M(const vector<S>& q) const {
        using std::cos;
        Eigen::Matrix<S, 5, 5> M = Eigen::Matrix<S, 5, 5>::Constant(S(0));
        M(0, 0) = S(mass * rho * rho);
        M(1, 1) = S(mass);
        M(2, 2) = M(3, 3) = M(4, 4) = S(inertia);
        M(2, 4) = M(4, 2) = S(inertia) * S(cos(q[3]));
        return M;
    }
    template <class S>
    vector<S> F(const vector<S>& q, const vector<S>& v) const {
        using std::sin;
        const S turn = S(inertia) * S(sin(q[3]));
        vector<S> F;
        F[0] = S(0);
        F[1] = S(-mass * gravity);
        F[2] = turn * v[4] * v[3];
        F[3] = -turn * v[2] * v[4];
        F[4] = turn * v[2] * v[3];
        return F;
    }
    /// The point of contact rests: rho chi' + r omega_z = 0, z' = r omega_chi, omega_chi the component of the
    /// angular velocity along the direction in which the centre circles.
    template <class S>
    Eigen::Matrix<S, 2, 5> G(const vector<S>& q) const {
        using std::cos;
        using std::sin;
        const S lag = q[2] - q[0];
        Eigen::Matrix<S, 2, 5> G = Eigen::Matrix<S, 2, 5>::Constant(S(0));
        G(0, 0) = S(rho);
        G(0, 2) = S(radius);
        G(0, 4) = S(radius) * S(cos(q[3]));
        G(1, 1) = S(1);
        G(1, 3) = S(-radius) * S(sin(lag));
        G(1, 4) = S(radius) * S(sin(q[3])) * S(cos(lag));
        return G;
    }
    template <class S>
    S potential(const vector<S>& q) const {
        return S(mass * gravity) * q[1];
    }
    template <class S>
    S singularity(const vector<S>& q) const {
        using std::sin;
        return sin(q[3]);
    }

    /// At z = 0, not rising, circling with chi' = omega and spinning with `spin` about the normal of contact.
    static vector<double> initial_position() {
        return (vector<double>() << 0, 0, 0, 1.5707963267948966, 0).finished();
    }
    vector<double> initial_velocity(double omega, double spin) const {
        return (vector<double>() << omega, 0, -rho * omega / radius, spin, 0).finished();
    }
    /// The height at time t of that motion: z'' = -(I (spin omega r + omega^2 z) + m g r^2)/(I + m r^2).
    double height(double omega, double spin, double t) const {
        const double k = std::sqrt(inertia / (inertia + mass * radius * radius)) * omega;
        const double fall = (spin * radius + mass * gravity * radius * radius / (inertia * omega)) / omega;
        return fall * (std::cos(k * t) - 1);
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
