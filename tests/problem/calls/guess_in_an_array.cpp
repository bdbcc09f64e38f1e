// SPDX-License-Identifier: BSL-1.0
// says: solve_bvp: guess must be a vector of Eigen's
// lines: 11
#include <array>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using stagecraft::solve_bvp, stagecraft::two_point;

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };
const auto r = [](const auto& a, const auto& b, auto& out) { out[0] = a[0], out[1] = b[0] - 1; };

auto run() { return solve_bvp(stagecraft::gauss<3>(), two_point(f, r), 0, 1, std::array<double, 2>{0, 0}); }
