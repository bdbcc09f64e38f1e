// SPDX-License-Identifier: BSL-1.0
// says: the problem must be callable as problem(t, y, f)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

#ifdef RIGHT
const auto problem = [](double, const Eigen::VectorXd& y, Vector2d& f) { f = -y; };
#else
const auto problem = [](double, const Vector3d& y, Vector2d& f) { f << -y[0], -y[1]; };
#endif

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
