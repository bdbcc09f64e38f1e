// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <stagecraft/bvp/orbit_continuation.hpp>
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/last_return.hpp>

int main() {  // van der Pol's orbits
    const auto on_path = [](double, const auto& y, const auto& p, auto& out) {
        out[0] = y[1], out[1] = p[0] * (1 - y[0] * y[0]) * y[1] - y[0];
    };
    const auto f = [](double, const auto& y, auto& out) {
        out[0] = y[1], out[1] = (1 - y[0] * y[0]) * y[1] - y[0];
    };
    const auto guess =
        stagecraft::last_return(stagecraft::radau_iia<3>(), f, Eigen::Vector2d(2, 0), 0.0, 40.0);
    const auto orbit = stagecraft::periodic_orbit(stagecraft::gauss<5>(), f, guess);
    const auto path =
        stagecraft::orbit_continuation(stagecraft::gauss<5>(), on_path, guess, {.from = 1, .to = 2});
    std::printf("%.6f %.6f\n", orbit.period, path.back().period);
}
