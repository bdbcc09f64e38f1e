// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

int main() {  // Troesch: y'' = 10 sinh 10 y
    const auto f = [](double, const auto& y, auto& out) {
        using std::sinh;
        out[0] = y[1], out[1] = 10 * sinh(10 * y[0]);
    };
    const auto ends = [](const auto& left, const auto& right, auto& r) {
        r[0] = left[0], r[1] = right[0] - 1.0;
    };
    const auto s = stagecraft::solve_bvp(stagecraft::gauss<3>(), stagecraft::two_point(f, ends), 0.0, 1.0,
                                         Eigen::Vector2d(0, 0));
    std::printf("%.6f\n", s.y(0.5)[0]);
}
