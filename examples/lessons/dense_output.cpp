// SPDX-License-Identifier: BSL-1.0
// Values between the steps: y(t) anywhere after the run, and a table at times given before it. Neither makes
// the run take other steps.
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/output_times.hpp>
#include <stagecraft/observe/solution.hpp>

using Eigen::Vector2d;

int main() {
    using namespace stagecraft;
    const auto oscillator = [](double, const Vector2d& y, Vector2d& f) { f << y[1], -y[0]; };
    solution<Vector2d> y;
    output_times<Vector2d> table({0, 1, 2, 3});
    // With continuous = true the tolerance holds between the ends of the steps as well.
    const auto r = integrate(gauss<4>(), oscillator, Vector2d(0, 1), 0, 3,
                             {.rtol = 1e-8, .atol = 1e-8, .continuous = true}, observers(y, table));
    for (int i = 0; i < table.filled(); ++i)
        std::printf("y(%.0f) = %.6f   sin %.0f = %.6f\n", table.time(i), table.y(i)[0], table.time(i),
                    std::sin(table.time(i)));
    std::printf("y(pi/6) = %.6f, y'(pi/6) = %.6f, %s\n", y(M_PI / 6)[0], y.derivative(M_PI / 6)[0],
                y.steps() == r.report.steps ? "one piece per step" : "?");
}
