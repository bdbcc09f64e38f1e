// SPDX-License-Identifier: BSL-1.0
// Boundary values: Bratu's problem y'' = -exp(y), y(0) = y(1) = 0, has two solutions. Which one is found
// depends on the guess; how good it is, is estimated.
#include <cmath>
#include <cstdio>
#include <stagecraft/bvp/solve.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d;

int main() {
    // Both are generic in the scalar type, so that their derivatives are automatic.
    const auto bratu = stagecraft::two_point(
        [](const auto&, const auto& y, auto& f) {
            using std::exp;
            f[0] = y[1], f[1] = -exp(y[0]);
        },
        [](const auto& left, const auto& right, auto& r) { r[0] = left[0], r[1] = right[0]; });

    for (const double height : {0.0, 4.0}) {
        const auto guess = [height](double t) {
            return Vector2d(4 * height * t * (1 - t), 4 * height * (1 - 2 * t));
        };
        const auto r = stagecraft::solve_bvp(stagecraft::gauss<4>(), bratu, 0, 1, guess, {.rtol = 1e-8});
        if (!r.ok()) return std::printf("%s: %s\n", name(r.status), r.message.c_str());
        // The exact solutions belong to the two roots of a = sqrt(2) cosh(a / 4).
        const double a = height == 0 ? 1.5171645990507544 : 10.938702772115119;
        const double error = std::abs(r.y(0.5)[0] - 2 * std::log(std::cosh(a / 4)));
        std::printf("y(1/2) = %.6f, error below 1e-7: %s, estimated so: %s\n", r.y(0.5)[0],
                    error < 1e-7 ? "yes" : "no", r.error.components[0] < 1e-7 ? "yes" : "no");
    }
}
