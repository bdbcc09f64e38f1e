// SPDX-License-Identifier: BSL-1.0
// says: the problem returns a vector of another size than y0
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y) { return Eigen::Vector3d(y[0], y[1], 0); };

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
