// SPDX-License-Identifier: BSL-1.0
// says: problem.jacobian must be a member function `void jacobian(double t, const Vector& y, Matrix& J) const`
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

struct stiff {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f << -1e5 * y[0], -y[1]; }
    void jacobian(double, const Vector2d&, Eigen::Matrix2d J) const { J << -1e5, 0, 0, -1; }
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), stiff{}, Vector2d(1, 1), 0, 1); }
