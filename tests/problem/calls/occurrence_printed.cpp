// SPDX-License-Identifier: BSL-1.0
// says: print the event's number o.event, its time o.t and its state o.y
// lines: 9
#include <iostream>
#include <stagecraft/observe/event.hpp>

void print(const stagecraft::event_watch<Eigen::Vector2d>& watch) {
    for (const auto& o : watch) std::cout << o;
}
