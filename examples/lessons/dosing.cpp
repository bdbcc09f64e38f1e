// SPDX-License-Identifier: BSL-1.0
// A drug is infused for an hour every twelve hours, and a tablet is taken at 8 and at 30 h. What happens at known times is
// said, and not looked for: steps end there, and it is one run, with one table.
#include <cmath>
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/at.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/output_times.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector2d;
    // gut -> blood -> out; the infusion goes into the blood.
    const auto body = [](double t, const Vector2d& y, Vector2d& f) {
        const double infusion = std::fmod(t, 12) < 1 ? 5 : 0;
        f << -0.7 * y[0], 0.7 * y[0] - 0.2 * y[1] + infusion;
    };
    output_times<Vector2d> table({0, 1, 8, 8, 12, 13, 24, 30, 30, 48});
    const auto run = [&](const options<double>& o) {
        return integrate(radau_iia<3>(), body, Vector2d(0, 0), 0, 48, o,
                         observers(at({8.0, 30.0}, [](double, Vector2d& y) { y[0] += 10; }), table));
    };
    const auto said = run({.rtol = 1e-8, .atol = 1e-8, .break_points = every(12.0, {0.0, 1.0})});
    std::printf("   t    gut   blood\n");
    for (int i = 0; i < table.filled(); ++i)  // a time that is given twice: before the tablet and behind it
        std::printf("%4.0f %6.3f %7.4f\n", table.time(i), table.y(i)[0], table.y(i)[1]);
    // The same in closed form: each dose decays by itself.
    double blood = 0;
    for (const double begin : {0, 12, 24, 36})
        blood += 25 * (1 - std::exp(-0.2)) * std::exp(-0.2 * (48 - begin - 1));
    for (const double tablet : {8, 30})
        blood += 14 * (std::exp(-0.2 * (48 - tablet)) - std::exp(-0.7 * (48 - tablet)));
    std::printf("off by less than 1e-6: %s\n", std::abs(said.y[1] - blood) < 1e-6 ? "yes" : "no");
}
