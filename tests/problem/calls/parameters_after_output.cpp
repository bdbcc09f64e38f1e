// SPDX-License-Identifier: BSL-1.0
// says: with a guess for parameters as f(t, y, p, out)
// lines: 8
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d;

const auto f = [](const auto&, const auto& y, auto& out, const auto& p) {
    out[0] = y[1], out[1] = -p[0] * y[0];
};
const auto r = [](const auto& left, const auto& right, auto& out, const auto&) {
    out[0] = left[0], out[1] = right[0], out[2] = left[1] - 1;
};

auto run() {
    return stagecraft::solve_bvp(stagecraft::gauss<3>(), stagecraft::two_point(f, r), 0.0, 1.0,
                                 Vector2d(0, 1), Eigen::Matrix<double, 1, 1>(9.0));
}
