// SPDX-License-Identifier: BSL-1.0
// says: problem.jacobian must be a member function
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

struct linear {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    void jacobian(double, const Vector2d&, Eigen::MatrixXd& J) const { J = -Eigen::Matrix2d::Identity(); }
};
const linear problem;

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
