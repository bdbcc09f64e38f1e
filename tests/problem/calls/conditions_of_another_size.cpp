// SPDX-License-Identifier: BSL-1.0
// says: the second argument of two_point must be callable as r(left, right, out)
// lines: 11
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d, Eigen::Vector3d, stagecraft::two_point;

const auto f = [](double, const Vector2d& y, Vector2d& out) { out << y[1], -y[0]; };
#ifdef RIGHT
const auto r = [](const Vector2d& a, const Vector2d& b, Vector2d& out) { out << a[0], b[0] - 1; };
#else
const auto r = [](const Vector2d& a, const Vector3d& b, Vector2d& out) { out << a[0], b[0] - 1; };
#endif

auto run() { return stagecraft::solve_bvp(stagecraft::gauss<3>(), two_point(f, r), 0, 1, Vector2d(1, 1)); }
