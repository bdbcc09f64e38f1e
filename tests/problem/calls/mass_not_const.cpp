// SPDX-License-Identifier: BSL-1.0
// says: problem.mass must be a member function
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

struct massive {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    Eigen::Matrix2d mass() { return Eigen::Matrix2d::Identity(); }
};
const massive problem;

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
