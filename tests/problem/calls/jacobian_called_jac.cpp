// SPDX-License-Identifier: BSL-1.0
// says: and not jac or mass_matrix
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

struct problem {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    void jac(double, const Vector2d&, Eigen::Matrix2d& J) const { J = -Eigen::Matrix2d::Identity(); }
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem{}, Vector2d(1, 1), 0, 1); }
