// SPDX-License-Identifier: BSL-1.0
// A wave on a million points: no room for the slopes of nine stages. Methods written in registers overwrite two vectors, and one
// of them brings an error estimate along.
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/low_storage.hpp>
#include <stagecraft/low_storage.hpp>

using Eigen::VectorXd;

int main() {
    // u_t + u_x = 0 on a circle of n points, differences of order four.
    constexpr int n = 200;  // a million as well
    const auto transport = [](double, const VectorXd& u, VectorXd& f) {
        for (int i = 0; i < n; ++i) {
            const auto at = [&](int k) { return u[(i + k + n) % n]; };
            f[i] = -n * (at(-2) - 8 * at(-1) + 8 * at(1) - at(2)) / 12;
        }
    };
    VectorXd u0(n);
    for (int i = 0; i < n; ++i) u0[i] = std::exp(std::sin(2 * M_PI * i / n));

    // Equal steps: Carpenter and Kennedy's five stages in two registers (2N).
    const auto equal = stagecraft::integrate(stagecraft::carpenter_kennedy_2n_5_4(), transport, u0, 0, 1,
                                             {.fixed_step = 1.0 / n});
    // Steps chosen by the estimate of a method for three registers (3S*), nine stages.
    const auto chosen = stagecraft::integrate(stagecraft::ranocha_3s_4_3(), transport, u0, 0, 1,
                                              {.rtol = 1e-6, .atol = 1e-6});
    std::printf("once around: error %.0e with equal steps, %.0e with chosen ones\n",
                (equal.y - u0).cwiseAbs().maxCoeff(), (chosen.y - u0).cwiseAbs().maxCoeff());
    // As a tableau it makes the same steps, and keeps five slopes.
    const auto whole = stagecraft::integrate(stagecraft::carpenter_kennedy_2n_5_4().meaning, transport, u0, 0,
                                             1, {.fixed_step = 1.0 / n});
    std::printf("as a tableau: %s\n", (whole.y - equal.y).norm() < 1e-10 ? "the same" : "another solution");
}
