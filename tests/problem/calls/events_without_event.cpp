// SPDX-License-Identifier: BSL-1.0
// says: event() around g
// lines: 8
#include <stagecraft/observe/event.hpp>

using Eigen::Vector2d;

const auto g = [](double, const Vector2d& y) { return y[0]; };

auto run() { return stagecraft::events<Vector2d>(g); }
