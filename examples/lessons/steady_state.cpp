// SPDX-License-Identifier: BSL-1.0
// Where a reaction ends, and when: a run without an end of its own, which stops where nothing moves any more.
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/steady_state.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector3d;
    // A <-> B quickly, B <-> C slowly: at rest A : B : C = 1 : 2 : 4.
    const auto reaction = [](double, const Vector3d& y, Vector3d& f) {
        const double first = 1e4 * (2 * y[0] - y[1]), second = 1e-2 * (2 * y[1] - y[2]);
        f << -first, first - second, second;
    };
    for (const double tolerance : {1e-4, 1e-8}) {
        const auto r = integrate(radau_iia<3>(), reaction, Vector3d(7, 0, 0), 0, 1e9,
                                 {.rtol = 1e-8, .atol = 1e-10}, steady_state(tolerance));
        std::printf("%s between t = 100 and 1500: %s;  y = %.1f %.1f %.1f\n", name(r.status),
                    r.t > 100 && r.t < 1500 ? "yes" : "no", r.y[0], r.y[1], r.y[2]);
    }
}
