// SPDX-License-Identifier: BSL-1.0
// says: guess is a vector with its type, Eigen::Vector2d(0, 1), say, not {0, 1}
// lines: 8
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };
const auto r = [](const auto& left, const auto& right, auto& out) {
    out[0] = left[0], out[1] = right[0] - 1;
};

auto run() {
    return stagecraft::solve_bvp(stagecraft::gauss<3>(), stagecraft::two_point(f, r), 0, 1, {0, 1});
}
