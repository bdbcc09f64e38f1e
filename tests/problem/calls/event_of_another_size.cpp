// SPDX-License-Identifier: BSL-1.0
// says: g in event(g) must be callable as g(t, y)
// lines: 8
#include <stagecraft/observe/event.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

#ifdef RIGHT
const auto height = [](double, const Vector2d& y) { return y[0]; };
#else
const auto height = [](double, const Vector3d& y) { return y[0]; };
#endif

auto watch = stagecraft::events<Vector2d>(stagecraft::event(height));
