// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <type_traits>

#include <stagecraft/linear/norms.hpp>

namespace stagecraft::detail {

/// Where along x f seems to have a kink, a jump or the end of its domain: where the difference quotients to both sides of y
/// are others, at steps so small that those of smooth functions agree. In words that follow a reason; empty where there is
/// no such place. Costs seven evaluations of f for every node; false alarms are steep functions that no node resolves.
template <class Equations>
std::string kink_along(Equations& e, const typename Equations::iterate& x) {
    using std::abs;
    using scalar = std::decay_t<decltype(x.t[0])>;
    using state = typename Equations::state;
    const int n = e.n();
    state scale(n);
    for (int c = 0; c < n; ++c) scale[c] = x.y.row(c).cwiseAbs().maxCoeff();
    const scalar whole = std::max(scalar(scale.maxCoeff()), scalar(1) / 1000);
    for (int c = 0; c < n; ++c) scale[c] = std::max(scale[c], scalar(whole / 100)) * (c % 2 ? -1 : 1);
    std::ostringstream text;
    for (const double part : {1e-6, 1e-4, 1e-2}) {  // of the size of y
        scalar largest(0), most(0), place(0);
        for (const bool look : {false, true})  // the second time beside the largest
            for (int i = 0; i <= x.intervals(); ++i) {
                // Inside the first and the last interval, at whose ends f may be singular.
                const scalar t = i == 0               ? scalar(x.t[0] + x.h(0) / 100)
                                 : i == x.intervals() ? scalar(x.t[i] - x.h(i - 1) / 100)
                                                      : x.t[i];
                const state y = x.y.col(i), step = scalar(part) * scale, f = e.slope(t, y, x.p),
                            up = e.slope(t, state(y + step), x.p) - f,
                            down = f - e.slope(t, state(y - step), x.p);
                if (!all_finite(f, n)) continue;
                if (!all_finite(up, n) || !all_finite(down, n)) {
                    text << "; f is not finite beside it at t = " << t;
                    return text.str();
                }
                if (!look) {
                    largest = std::max(
                        {largest, scalar(up.cwiseAbs().maxCoeff()), scalar(down.cwiseAbs().maxCoeff())});
                    continue;
                }
                for (int c = 0; c < n; ++c) {
                    const scalar size = std::max(abs(up[c]), abs(down[c])), off = abs(up[c] - down[c]);
                    if (off > size / 2 && off > most && off > largest / 100) most = off, place = t;
                }
            }
        if (!(most > scalar(0))) continue;
        text << "; f seems to have a kink or a jump in y at t = " << place;
        return text.str();
    }
    return {};
}

}  // namespace stagecraft::detail
