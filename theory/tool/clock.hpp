// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <unistd.h>

#include <limits>
#include <string>
#include <utility>

namespace stagecraft::tool {

/// Seconds that a decision may take (--seconds), 0: any; and of several files the one at work, for the message.
inline unsigned seconds_allowed = 60;
inline std::string file_at_work;

/// Starts the clock anew: each of several files has the seconds allowed for itself.
inline void start_clock(std::string file = {}) {
    alarm(0);
    file_at_work = std::move(file);
    alarm(seconds_allowed);
}

/// What of it the decisions on one file may take together, so that what is known is printed before the clock runs out.
inline double seconds_for_decisions() {
    return seconds_allowed == 0 ? std::numeric_limits<double>::infinity() : 0.8 * seconds_allowed;
}

}  // namespace stagecraft::tool
