// SPDX-License-Identifier: BSL-1.0
// says: options have no other names than {.rtol, .atol
// lines of g++: 8
// lines: 11
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/gauss_variable.hpp>

using Eigen::Vector2d, stagecraft::gauss_variable, stagecraft::solve_bvp, stagecraft::two_point;

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };
const auto r = [](const auto& left, const auto& right, auto& out) {
    out[0] = left[0], out[1] = right[0] - 1;
};

auto run() { return solve_bvp(gauss_variable(), two_point(f, r), 0, 1, Vector2d(0, 0), {.tolerance = 1e-8}); }
