// SPDX-License-Identifier: BSL-1.0
// says: step_doubling(method): the method must be a tableau, gauss<3>() with its parentheses
// lines: 11
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/method/step_doubling.hpp>

using Eigen::Vector2d, stagecraft::gauss;

const auto f = [](double, const Vector2d& y, Vector2d& out) { out = -y; };

#ifdef RIGHT
auto run() { return stagecraft::integrate(stagecraft::step_doubling(gauss<3>()), f, Vector2d(1, 1), 0, 1); }
#else
auto run() { return stagecraft::integrate(stagecraft::step_doubling(gauss<3>), f, Vector2d(1, 1), 0, 1); }
#endif
