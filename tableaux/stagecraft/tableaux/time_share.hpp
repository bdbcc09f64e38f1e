// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <stagecraft/tableaux/precision.hpp>

namespace stagecraft::tableaux {

/// Thrown where a decision has used up its share of the time.
struct out_of_time : undecided {
    out_of_time() : undecided("not within its share of the time") {}
};

/// While it lives, exact and enclosed arithmetic of this thread throws out_of_time after so many seconds (infinity:
/// never). A share within another ends with it at the latest. The clock is read every thousand operations.
class time_share {
  public:
    using clock = std::chrono::steady_clock;

    explicit time_share(double seconds) : outer_(end_) {
        if (seconds < 1e9)
            end_ = std::min(outer_, clock::now() + std::chrono::duration_cast<clock::duration>(
                                                       std::chrono::duration<double>(seconds)));
    }
    ~time_share() { end_ = outer_; }
    time_share(const time_share&) = delete;
    time_share& operator=(const time_share&) = delete;

    /// Seconds left of the innermost share; infinity where there is none.
    static double left() {
        if (end_ == clock::time_point::max()) return std::numeric_limits<double>::infinity();
        return std::chrono::duration<double>(end_ - clock::now()).count();
    }
    /// For arithmetic: throws out_of_time where the share is used up, once in a thousand calls.
    static void check() {
        if (--countdown_ <= 0) check_now();
    }
    /// For loops of long steps: throws out_of_time where the share is used up.
    static void check_now() {
        countdown_ = 1000;
        if (end_ != clock::time_point::max() && clock::now() > end_) throw out_of_time();
    }

  private:
    clock::time_point outer_;
    static inline thread_local clock::time_point end_ = clock::time_point::max();
    static inline thread_local int countdown_ = 1000;
};

}  // namespace stagecraft::tableaux
