// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>

#include <stagecraft/bvp/equations/mesh.hpp>
#include <stagecraft/problem/system.hpp>

namespace stagecraft::detail {

/// y of n components at the mesh points of x and its scaled slopes at the nodes c of every interval, from a guess.
template <class Guess, class Nodes, class Iterate>
void take_guess(const Guess& guess, int n, const Nodes& c, Iterate& x) {
    const int s = static_cast<int>(c.size());
    x.y.resize(n, x.intervals() + 1);
    x.Z.resize(n, s * x.intervals());
    for (int i = 0; i <= x.intervals(); ++i) x.y.col(i) = guess_value(guess, x.t[i], x.y.rows());
    for (int i = 0; i < x.intervals(); ++i)
        for (int j = 0; j < s; ++j) {
            auto h = x.h(i);
            x.Z.col(i * s + j) = h * guess_slope(guess, decltype(h)(x.t[i] + c[j] * h), h, x.y.rows());
        }
    if (!x.y.allFinite() || !x.p.allFinite()) throw bad_problem("solve_bvp: guess must be finite");
}

/// The mesh values of x as a guess, straight lines between them.
template <class Vector, class Iterate>
auto straight_between(const Iterate& x) {
    return [t = x.t, y = x.y](const typename Vector::Scalar& time) {
        const auto last = static_cast<Eigen::Index>(t.size()) - 1;
        const auto i = std::clamp(std::upper_bound(t.begin(), t.end(), time) - t.begin() - 1,
                                  std::ptrdiff_t(0), last - 1);
        const typename Vector::Scalar theta = (time - t[i]) / (t[i + 1] - t[i]);
        return Vector(y.col(i) + theta * (y.col(i + 1) - y.col(i)));
    };
}

}  // namespace stagecraft::detail
