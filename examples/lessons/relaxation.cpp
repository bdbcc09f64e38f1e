// SPDX-License-Identifier: BSL-1.0
// A predator, its prey, and what no explicit method knows: the orbits of Lotka and Volterra are closed. A relaxed method stays on
// its orbit, because each step is made as long as that asks for.
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/explicit.hpp>
#include <stagecraft/relaxation.hpp>

using Eigen::Vector2d;

int main() {
    const auto f = [](double, const Vector2d& y, Vector2d& dy) {
        dy << y[0] * (1 - y[1]), y[1] * (y[0] - 1);
    };
    // The invariant, generic in its numbers: its derivative along f is known then, and not taken for zero.
    const auto eta = [](const auto& y) {
        using std::log;
        return y[0] - log(y[0]) + y[1] - log(y[1]);
    };

    const auto method = stagecraft::bogacki_shampine_3_2();
    const Vector2d y0(1, 2);
    const stagecraft::options<double> o{.rtol = 1e-4, .atol = 1e-4};
    const auto plain = stagecraft::integrate(method, f, y0, 0, 500, o);
    const auto relaxed = stagecraft::integrate(stagecraft::relaxation(method, eta), f, y0, 0, 500, o);
    const auto off = [&](const auto& r) { return std::abs(eta(r.y) - eta(y0)); };
    std::printf("eta is off by %.0g at t = 500, relaxed by less than 1e-12: %s\n", off(plain),
                off(relaxed) < 1e-12 ? "yes" : "no");
    std::printf("evaluations of f: %.1f times as many\n", double(relaxed.report.f) / double(plain.report.f));
}
