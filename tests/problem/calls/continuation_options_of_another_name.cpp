// SPDX-License-Identifier: BSL-1.0
// says: the path begins at p = from
// lines: 11
#include <stagecraft/bvp/continuation.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d, stagecraft::gauss, stagecraft::continuation, stagecraft::two_point;

const auto f = [](const auto&, const auto& y, const auto& p, auto& out) {
    out[0] = y[1], out[1] = -p[0] * y[0];
};
const auto r = [](const auto& left, const auto& right, const auto&, auto& out) {
    out[0] = left[0], out[1] = right[0];
};

auto run() { return continuation(gauss<3>(), two_point(f, r), 0, 1, Vector2d(0, 0), {.start = 1}); }
