// SPDX-License-Identifier: BSL-1.0
// says: direction is crossing::both
// lines: 11
#include <stagecraft/observe/event.hpp>

using Eigen::Vector2d, stagecraft::event, stagecraft::events;

const auto g = [](double, const Vector2d& y) { return y[0]; };

auto run() { return events<Vector2d>(event(g, {.direction = -1})); }
