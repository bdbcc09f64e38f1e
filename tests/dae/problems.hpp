// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/integrate.hpp>

// Differential-algebraic problems with known solutions, in the forms the tests compare.
namespace dae {

// The index-2 problem of HLR89: solution (e^t, e^-2t, e^2t). Any vectors with two, one components.
// With its mass matrix it is equations::index_two.
struct hlr_f {
    template <class T, class Y, class Z, class Out>
    void operator()(const T&, const Y& y, const Z& z, Out& f) const {
        f[0] = y[0] * y[1] * y[1] * z[0] * z[0];
        f[1] = y[0] * y[0] * y[1] * y[1] - 3 * y[1] * y[1] * z[0];
    }
};
struct hlr_g {
    template <class T, class Y, class Out>
    void operator()(const T&, const Y& y, Out& g) const {
        g[0] = y[0] * y[0] * y[1] - 1;
    }
};

// The pendulum q'' = (0, -1) - q lambda, 0 = (q.q - 1)/2, with y = (q, v), z = lambda.
struct pendulum_f {
    template <class T, class Y, class Z, class Out>
    void operator()(const T&, const Y& y, const Z& z, Out& f) const {
        f[0] = y[2];
        f[1] = y[3];
        f[2] = -y[0] * z[0];
        f[3] = -y[1] * z[0] - 1.0;
    }
};
struct pendulum_position {
    template <class T, class Y, class Out>
    void operator()(const T&, const Y& y, Out& g) const {
        g[0] = (y[0] * y[0] + y[1] * y[1] - 1.0) / 2.0;
    }
};
struct pendulum_velocity {
    template <class T, class Y, class Out>
    void operator()(const T&, const Y& y, Out& g) const {
        g[0] = y[0] * y[2] + y[1] * y[3];
    }
};
struct pendulum_acceleration {
    template <class T, class Y, class Z, class Out>
    void operator()(const T&, const Y& y, const Z& z, Out& g) const {
        g[0] = y[2] * y[2] + y[3] * y[3] - y[1] - (y[0] * y[0] + y[1] * y[1]) * z[0];
    }
};
// Index 3: the constraint of position.
struct pendulum_3 {
    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, 5, 1>& x, Eigen::Matrix<S, 5, 1>& f) const {
        const Eigen::Matrix<S, 4, 1> y = x.template head<4>();
        const Eigen::Matrix<S, 1, 1> z = x.template tail<1>();
        Eigen::Matrix<S, 4, 1> a;
        Eigen::Matrix<S, 1, 1> b;
        pendulum_f{}(t, y, z, a);
        pendulum_position{}(t, y, b);
        f << a, b;
    }
    Eigen::DiagonalMatrix<double, 5> mass() const {
        Eigen::DiagonalMatrix<double, 5> m;
        m.diagonal() << 1, 1, 1, 1, 0;
        return m;
    }
    std::array<int, 5> index() const { return {1, 1, 2, 2, 3}; }
};
// The index-reduced pendulum: lambda eliminated, a differential equation in (q, v) whose length drifts.
struct pendulum_reduced {
    template <class S>
    void operator()(const S& t, const Eigen::Matrix<S, 4, 1>& y, Eigen::Matrix<S, 4, 1>& f) const {
        Eigen::Matrix<S, 1, 1> lambda;
        lambda[0] = (y[2] * y[2] + y[3] * y[3] - y[1]) / (y[0] * y[0] + y[1] * y[1]);
        pendulum_f{}(t, y, lambda, f);
    }
};

// (q, v) at time t from rest at (1, 0), by the angle: phi'' = -sin phi measured from the lowest point.
inline Eigen::Vector4d pendulum_by_angle(double t) {
    const auto angle = [](double, const Eigen::Vector2d& y, Eigen::Vector2d& f) {
        f << y[1], -std::sin(y[0]);
    };
    const double half_pi = 1.57079632679489661923;
    const auto r = stagecraft::integrate(stagecraft::gauss<5>(), angle, Eigen::Vector2d(half_pi, 0), 0, t,
                                         {.rtol = 1e-14, .atol = 1e-14});
    const double s = std::sin(r.y[0]), c = std::cos(r.y[0]);
    return {s, -c, r.y[1] * c, r.y[1] * s};
}

// Implicit in y', F_{y'} = 1 + 3 v^2 regular: v + v^3 = c(t) + c(t)^3 with solution y = sin t, v = cos t.
struct cubic {
    template <class S, class Y>
    void operator()(const S& t, const Y& y, const Y& v, Y& out) const {
        using std::cos;
        using std::sin;
        const auto c = cos(t);
        out[0] = v[0] + v[0] * v[0] * v[0] - c - c * c * c + y[0] - sin(t);
    }
};
// y' = z, 0 = z + y in double only: index 1, differentiated by differences.
inline const auto decay = [](double, const Eigen::VectorXd&, const Eigen::VectorXd& z, Eigen::VectorXd& f) {
    f = z;
};
inline const auto decay_constraint = [](double, const Eigen::VectorXd& y, const Eigen::VectorXd& z,
                                        Eigen::VectorXd& g) { g = z + y; };

}  // namespace dae
