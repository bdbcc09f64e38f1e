// SPDX-License-Identifier: BSL-1.0
// says: fixed_point(method): the method must be a tableau, gauss<3>() with its parentheses
// lines: 11
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/fixed_point.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d, stagecraft::gauss;

const auto f = [](double, const Vector2d& y, Vector2d& out) { out = -y; };

#ifdef RIGHT
auto run() { return stagecraft::integrate(stagecraft::fixed_point(gauss<3>()), f, Vector2d(1, 1), 0, 1); }
#else
auto run() { return stagecraft::integrate(stagecraft::fixed_point(gauss<3>), f, Vector2d(1, 1), 0, 1); }
#endif
