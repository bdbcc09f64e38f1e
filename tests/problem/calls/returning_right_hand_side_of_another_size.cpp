// SPDX-License-Identifier: BSL-1.0
// says: the problem must be callable as problem(t, y, f)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

const auto problem = [](double, const Vector3d& y) { return Vector2d(-y[0], -y[1]); };

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
