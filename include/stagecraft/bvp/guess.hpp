// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/bvp/mesh.hpp>
#include <stagecraft/problem/system.hpp>

namespace stagecraft::detail {

/// y at the mesh points of x and its scaled slopes at the nodes c of every interval, from a guess.
template <class Guess, class Nodes, class Iterate>
void take_guess(const Guess& guess, const Nodes& c, Iterate& x) {
    const int s = static_cast<int>(c.size());
    for (int i = 0; i <= x.intervals(); ++i) x.y.col(i) = guess_value(guess, x.t[i], x.y.rows());
    for (int i = 0; i < x.intervals(); ++i)
        for (int j = 0; j < s; ++j) {
            auto h = x.h(i);
            x.Z.col(i * s + j) = h * guess_slope(guess, decltype(h)(x.t[i] + c[j] * h), h, x.y.rows());
        }
    if (!x.y.allFinite() || !x.p.allFinite()) throw bad_problem("solve_bvp: guess must be finite");
}

}  // namespace stagecraft::detail
