// SPDX-License-Identifier: BSL-1.0
// says: returns a bool, whose change of sign is none
// lines: 8
#include <stagecraft/observe/event.hpp>

using Eigen::Vector2d;

auto watch() {
    return stagecraft::events<Vector2d>(
        stagecraft::event([](double, const Vector2d& y) { return y[0] < 1; }));
}
