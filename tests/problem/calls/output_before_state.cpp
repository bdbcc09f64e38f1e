// SPDX-License-Identifier: BSL-1.0
// says: the problem must be callable as problem(t, y, f)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](auto& f, const auto& y, double) { f[0] = y[1], f[1] = -y[0]; };

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
