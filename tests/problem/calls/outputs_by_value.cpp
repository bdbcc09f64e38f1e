// SPDX-License-Identifier: BSL-1.0
// says: fully_implicit: F takes out by value, or const, and what it writes is lost: write `Vector& out` or `auto& out`
// says: projection_onto<M>(g): g takes out by value, or const, and what it writes is lost
// says: sensitivities and adjoint_gradient: the problem takes f by value, or const, and what it writes is lost
// says: problem.parameter_jacobian(t, y, p, F) takes F by value, and what it writes is lost
// says: integrate: the problem takes f by value, or const, and what it writes is lost: write `State& f`
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/fully_implicit.hpp>
#include <stagecraft/sensitivity/forward.hpp>
#include <stagecraft/states.hpp>

using V1 = Eigen::Matrix<double, 1, 1>;
using Eigen::Vector2d;

#ifdef RIGHT
#define OUT &
#else
#define OUT
#endif

const auto implicit = [](double, const Vector2d& y, const Vector2d& v, Vector2d OUT out) { out = y + v; };
auto equations = stagecraft::fully_implicit<2>(implicit);

const auto rotation = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -y[0]; };
const auto length = [](double, const Vector2d& y, V1 OUT out) { out[0] = y.squaredNorm() - 1; };
auto projected() {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), rotation, Vector2d(1, 0), 0, 1, {},
                                 stagecraft::projection_onto<1>(length));
}

const auto decay = [](const auto&, const auto& y, const auto& p, auto OUT f) { f[0] = -p[0] * y[0]; };
struct with_derivative {
    void operator()(double, const V1& y, const V1& p, V1& f) const { f[0] = -p[0] * y[0]; }
    void jacobian(double, const V1&, const V1& p, V1& J) const { J(0, 0) = -p[0]; }
    void parameter_jacobian(double, const V1& y, const V1&, V1 OUT F) const { F(0, 0) = -y[0]; }
};
auto derived() {
    return stagecraft::sensitivities(stagecraft::radau_iia<2>(), decay, V1(1.0), V1(2.0), 0, 1);
}
auto given() {
    return stagecraft::sensitivities(stagecraft::radau_iia<2>(), with_derivative{}, V1(1.0), V1(2.0), 0, 1);
}

const auto number = [](double, double y, double OUT f) { f = -y; };
auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), number, 1.0, 0, 1); }

#undef OUT
