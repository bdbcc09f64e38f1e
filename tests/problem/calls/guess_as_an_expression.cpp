// SPDX-License-Identifier: BSL-1.0
// says: a function of t that returns one (no expression: write `-> Eigen::Vector2d` or .eval()), or a solution
// lines: 11
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d, stagecraft::solve_bvp, stagecraft::two_point;

const auto f = [](double, const Vector2d& y, Vector2d& out) { out << y[1], -y[0]; };
const auto r = [](const Vector2d& a, const Vector2d& b, auto& out) { out << a[0], b[0] - 1; };
#ifdef RIGHT
const auto guess = [](double t) -> Vector2d {
#else
const auto guess = [](double t) {
#endif
    const Vector2d slope(1, 0);
    return t * slope;
};

auto run() { return solve_bvp(stagecraft::gauss<3>(), two_point(f, r), 0, 1, guess); }
