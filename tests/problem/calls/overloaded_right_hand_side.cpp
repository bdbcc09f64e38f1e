// SPDX-License-Identifier: BSL-1.0
// says: the name of overloaded functions or of a template cannot be passed as the problem
// lines: 20
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

void decay(double, const Vector2d& y, Vector2d& f) { f = -y; }
void decay(double, const Vector3d& y, Vector3d& f) { f = -y; }

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), decay, Vector2d(1, 1), 0, 1); }
