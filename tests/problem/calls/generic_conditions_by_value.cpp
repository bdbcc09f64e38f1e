// SPDX-License-Identifier: BSL-1.0
// says: f or r of two_point(f, r) takes out by value, what it writes is lost
// lines: 11
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d, stagecraft::solve_bvp, stagecraft::two_point;
using parameter = Eigen::Matrix<double, 1, 1>;

const auto f = [](const auto&, const auto& y, const auto& p, auto& out) {
    out[0] = y[1], out[1] = p[0] * y[0];
};
const auto r = [](const auto& a, const auto& b, const auto&, auto out) {
    out[0] = a[0], out[1] = b[0], out[2] = a[1];
};

auto run() { return solve_bvp(stagecraft::gauss<3>(), two_point(f, r), 0, 1, Vector2d(1, 1), parameter(1)); }
