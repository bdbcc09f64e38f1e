// SPDX-License-Identifier: BSL-1.0
// says: a right-hand side is called as f(t, y, out)
// lines: 54
// lines of g++: 19
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

#ifdef RIGHT
const auto problem = [](const auto& t, const auto& y, auto& f) { f[0] = y[0] + t; };
#else
const auto problem = [](const auto& y, const auto& t, auto& f) { f[0] = y[0] + t; };
#endif

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
