// SPDX-License-Identifier: BSL-1.0
// says: or as problem(t, y) and return such a Vector
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <vector>

using Eigen::Vector2d;

#ifdef RIGHT
const auto problem = [](double, const Vector2d& y) { return Vector2d(y[1], -y[0]); };
#else
const auto problem = [](double, const Vector2d& y) { return std::vector{y[1], -y[0]}; };
#endif

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
