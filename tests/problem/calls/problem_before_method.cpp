// SPDX-License-Identifier: BSL-1.0
// says: the first argument must be a
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() { return stagecraft::integrate(problem, stagecraft::radau_iia<2>(), Vector2d(1, 1), 0, 1); }
