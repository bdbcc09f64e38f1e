// SPDX-License-Identifier: BSL-1.0
// says: returns the n x n matrix M
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

struct problem {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    Eigen::Matrix3d mass() const { return Eigen::Matrix3d::Identity(); }
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem(), Vector2d(1, 1), 0, 1); }
