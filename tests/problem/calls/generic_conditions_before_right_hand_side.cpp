// SPDX-License-Identifier: BSL-1.0
// says: conditions as r(left, right, out), and both as two_point(f, r)
// lines: 51
// lines of g++: 21
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d, stagecraft::solve_bvp, stagecraft::two_point;

const auto f = [](const auto&, const auto& y, auto& out) { out << y[1], -y[0]; };
const auto r = [](const auto& a, const auto& b, auto& out) { out << a[0], b[0] - 1; };

#ifdef RIGHT
auto run() { return solve_bvp(stagecraft::gauss<3>(), two_point(f, r), 0, 1, Vector2d(1, 1)); }
#else
auto run() { return solve_bvp(stagecraft::gauss<3>(), two_point(r, f), 0, 1, Vector2d(1, 1)); }
#endif
