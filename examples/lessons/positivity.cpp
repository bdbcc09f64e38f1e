// SPDX-License-Identifier: BSL-1.0
// A predator starves: its number goes to zero by what the tolerance leaves open, on either side. A square root of it
// would end the run; nonnegative(problem) keeps accepted states inside, and .clip takes tiny negative values for zero.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/with_domain.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector2d;
    const auto starving = [](double t, const Vector2d& y, Vector2d& f) {
        f << -y[0], (200 * std::cos(20 * t) - 300) * y[1];
    };
    const options<double> o{.rtol = 1e-4, .atol = 1e-4};
    const auto show = [&](const char* what, const auto& problem) {
        double least = 1;
        const auto r = integrate(radau_iia<3>(), problem, Vector2d(1, 1), 0, 20, o,
                                 [&](double, const Vector2d& y) { least = std::min(least, y.minCoeff()); });
        std::printf("%-12s %s, the least number is %s, %s\n", what, name(r.status),
                    least < 0 ? "negative" : "not negative",
                    r.report.clipped > 0 ? "some were clipped" : "none was clipped");
    };
    show("free", starving);
    show("nonnegative", nonnegative(starving));
    show("clipped", nonnegative(starving, {.clip = true}));
    // A domain makes no right-hand side right: where the solution leaves it the run ends, inside.
    const auto harvest = [](double, const Vector2d& y, Vector2d& f) { f << -1, -y[1]; };
    const auto r = integrate(radau_iia<3>(), nonnegative(harvest), Vector2d(1, 1), 0, 3);
    std::printf("%s at t = %.6f\n", name(r.status), r.t);
}
