// SPDX-License-Identifier: BSL-1.0
// says: the second argument of two_point must be callable as r(left, right, out)
// lines: 11
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d;

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };
const auto r = [](auto& out, const auto& left, const auto& right) {
    out[0] = left[0], out[1] = right[0] - 1;
};

auto run() {
    return stagecraft::solve_bvp(stagecraft::gauss<3>(), stagecraft::two_point(f, r), 0.0, 1.0,
                                 Vector2d(0, 1));
}
