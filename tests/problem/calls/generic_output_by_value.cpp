// SPDX-License-Identifier: BSL-1.0
// says: the problem takes f by value
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](auto, const auto& y, auto f) { f[0] = -y[0], f[1] = -y[1]; };

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
