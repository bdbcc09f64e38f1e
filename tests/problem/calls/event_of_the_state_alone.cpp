// SPDX-License-Identifier: BSL-1.0
// says: g in event(g) must be callable as g(t, y)
// lines: 8
#include <stagecraft/observe/event.hpp>

using Eigen::Vector2d;

auto watch = stagecraft::events<Vector2d>(stagecraft::event([](const Vector2d& y) { return y[0]; }));
