// SPDX-License-Identifier: BSL-1.0
// Error against step size: equal steps, no error estimate. The slope between two rows, both as logarithms, is the order.
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using number = Eigen::Matrix<double, 1, 1>;

stagecraft::tableau<double, 2> heun() {
    stagecraft::tableau<double, 2> m;
    m.A << 0, 0, 1, 0;
    m.b << 0.5, 0.5;
    m.c << 0, 1;
    return m;
}

// y' = y cos t, y(0) = 1 has the solution exp(sin t).
double error(const auto& method, double h) {
    const auto f = [](double t, const number& y, number& out) { out[0] = y[0] * std::cos(t); };
    // The tolerances say where Newton's iteration ends: far below the errors that are to be seen.
    const auto r =
        stagecraft::integrate(method, f, number(1.0), 0, 1, {.rtol = 1e-14, .atol = 1e-14, .fixed_step = h});
    return r.ok() ? std::abs(r.y[0] - std::exp(std::sin(1.0))) : NAN;
}

int main() {
    std::puts("# h       Heun           Gauss, s = 2   Radau IIA, s = 3");
    for (int n = 2; n <= 16; n *= 2) {
        std::printf("%-8g", 1.0 / n);
        const auto show = [&](const auto& method) {
            const double here = error(method, 1.0 / n), before = error(method, 2.0 / n);
            std::printf("  %.1e (%.1f)", here, std::log2(before / here));
        };
        show(heun()), show(stagecraft::gauss<2>()), show(stagecraft::radau_iia<3>());
        std::puts("");
    }
}
