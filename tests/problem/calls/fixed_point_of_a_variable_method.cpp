// SPDX-License-Identifier: BSL-1.0
// says: fixed_point(method): the method must be one tableau, radau_iia<3>(), say, with its parentheses
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/fixed_point.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>

using Eigen::Vector2d, stagecraft::fixed_point, stagecraft::radau_iia_variable;

const auto f = [](double, const Vector2d& y, Vector2d& out) { out = -y; };

#ifdef RIGHT
auto run() { return stagecraft::integrate(fixed_point(stagecraft::radau_iia<3>()), f, Vector2d(1, 1), 0, 1); }
#else
auto run() { return stagecraft::integrate(fixed_point(radau_iia_variable), f, Vector2d(1, 1), 0, 1); }
#endif
