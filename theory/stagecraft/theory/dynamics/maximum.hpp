// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "stagecraft/theory/dynamics/evaluate.hpp"

namespace stagecraft::theory {

/// Where a search on boxes ends: at an enclosure of this width, absolute and relative to its size, or at this
/// many boxes.
struct search_limits {
    double absolute = 1e-9;
    double relative = 1e-3;
    std::size_t boxes = 100'000;
};

/// Enclosure of a maximum over a box: low is attained (at least) at `point`; not `complete` where the limit
/// of boxes came first. high is infinite where g could not be bounded.
template <int N>
struct enclosed_maximum {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    box<N> point;
    bool complete = false;
};

/// The maximum of g over a box by branch and bound: g(x) is an enclosure of g on the box x. Boxes with
/// -infinity as upper end do not count, so g may leave out parts of the box.
template <int N, class G>
enclosed_maximum<N> maximise(G g, const box<N>& start, const search_limits& limits = {}) {
    require_bounded<N>(start);
    struct part {
        double upper;
        box<N> x;
        bool operator<(const part& o) const { return upper < o.upper; }
    };
    std::priority_queue<part> open;
    enclosed_maximum<N> best;
    best.point = middle<N>(start);
    double closed = -std::numeric_limits<double>::infinity();  // boxes that cannot be divided any more
    const auto take = [&](const box<N>& x) {
        const box<N> m = middle<N>(x);
        if (const double v = g(m).low(); v > best.low) {
            best.low = v;
            best.point = m;
        }
        if (const double u = g(x).high(); u > best.low) open.push({u, x});
    };
    take(start);
    for (std::size_t count = 1; !open.empty(); count += 2) {
        const part top = open.top();
        best.high = std::max({top.upper, closed, best.low});
        const double size = std::max(std::abs(best.low), std::abs(best.high));
        if (best.high - best.low <= limits.absolute + limits.relative * (std::isfinite(size) ? size : 0.0)) {
            best.complete = true;
            return best;
        }
        if (count >= limits.boxes) return best;
        open.pop();
        const int k = widest<N>(top.x);
        const double cut = top.x[k].middle();
        if (cut == top.x[k].low() || cut == top.x[k].high()) {
            closed = std::max(closed, top.upper);
            continue;
        }
        box<N> left = top.x, right = top.x;
        left[k] = interval(top.x[k].low(), cut);
        right[k] = interval(cut, top.x[k].high());
        take(left);
        take(right);
    }
    best.high = std::max(closed, best.low);
    best.complete = closed <= best.low;
    return best;
}

}  // namespace stagecraft::theory
