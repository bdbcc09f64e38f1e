// SPDX-License-Identifier: BSL-1.0
// says: events: g in event(g) returns a product of Eigen's, whose operands may be gone before it is evaluated: write n.dot(y), or (n.transpose() * y).value()
// lines: 8
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>

const auto height = [](double, const Eigen::Vector2d& y) {
    const Eigen::RowVector2d n(0.6, 0.8);
#ifdef RIGHT
    return (n * y).value();
#else
    return n * y;
#endif
};

auto watch = stagecraft::events<Eigen::Vector2d>(stagecraft::event(height));
