// SPDX-License-Identifier: BSL-1.0
// A generator on a line: a fault of 0.1 s takes the line away, and the voltage, an algebraic component, jumps with it. Each
// switch asks for consistent values again, which .consistent_start finds before the next step and before anybody looks.
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/at.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/solution.hpp>
#include <stagecraft/problem/with.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector3d;
    double line = 1.8;  // susceptance; 0.4 while the fault lasts
    // Angle d, speed w, voltage v: d' = 314 w, w' = (0.8 - v line sin(d) - 2 w)/7, 0 = v - 1 + 0.1 line v^2 (1 - cos(d)).
    const auto swing = [&](double, const Vector3d& y, Vector3d& f) {
        const double d = y[0], w = y[1], v = y[2];
        f << 314 * w, (0.8 - v * line * std::sin(d) - 2 * w) / 7,
            v - 1 + 0.1 * line * v * v * (1 - std::cos(d));
    };
    const auto problem = with_mass(swing, Vector3d(1, 1, 0).asDiagonal());
    auto fault = at({0.5}, [&](double, Vector3d&) { line = 0.4; });
    auto cleared = at({0.6}, [&](double, Vector3d&) { line = 1.8; });
    solution<Vector3d> y;
    // The voltage of the start is a guess as well.
    const auto r =
        integrate(radau_iia<3>(), problem, Vector3d(0.46, 0, 1), 0, 2,
                  {.rtol = 1e-8, .atol = 1e-8, .consistent_start = true}, observers(fault, cleared, y));
    std::printf("%s in %ld steps\n", name(r.status), r.report.steps);
    for (const double t : {0.0, 0.4999, 0.5, 0.6, 2.0})
        std::printf("t = %.4f: angle %.4f, voltage %.4f\n", t, y(t)[0], y(t)[2]);
}
