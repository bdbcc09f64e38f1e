// SPDX-License-Identifier: BSL-1.0
// says: found
// lines: 8
#include <stagecraft/observe/event.hpp>

auto run(const stagecraft::event_watch<Eigen::Vector2d>& watch) {
    double last = 0;
    for (const auto& o : watch.found) last = o.t;
    return last;
}
