// SPDX-License-Identifier: BSL-1.0
// says: f or r of two_point(f, r) takes out by value, what it writes is lost
// lines: 11
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d, stagecraft::solve_bvp, stagecraft::two_point;

const auto f = [](double, const Vector2d& y, Vector2d& out) { out << y[1], -y[0]; };
const auto r = [](const Vector2d& a, const Vector2d& b, Vector2d out) { out << a[0], b[0] - 1; };

auto run() { return solve_bvp(stagecraft::gauss<3>(), two_point(f, r), 0, 1, Vector2d(1, 1)); }
