// SPDX-License-Identifier: BSL-1.0
// says: the observer must be callable as observer(t, y)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run(double& last) {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {},
                                 [&](const char*, const Vector2d& y) { last = y[1]; });
}
