// SPDX-License-Identifier: BSL-1.0
// says: gauss_variable() is of solve_bvp alone
// lines: 11
#include <stagecraft/bvp/continuation.hpp>
#include <stagecraft/gauss_variable.hpp>

using Eigen::Vector2d, stagecraft::two_point;

const auto f = [](const auto&, const auto& y, const auto& p, auto& out) {
    out[0] = y[1], out[1] = -p[0] * y[0];
};
const auto r = [](const auto& left, const auto& right, const auto&, auto& out) {
    out[0] = left[0], out[1] = right[0] - 1;
};

auto run() {
    return stagecraft::continuation(stagecraft::gauss_variable(), two_point(f, r), 0.0, 1.0, Vector2d(0, 0),
                                    {.from = 0.5});
}
