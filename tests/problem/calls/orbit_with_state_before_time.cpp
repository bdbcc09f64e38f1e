// SPDX-License-Identifier: BSL-1.0
// says: f is called as f(t, y, out)
// lines: 11
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d;

const auto f = [](const auto& y, auto& out, auto) { out[0] = y[1], out[1] = -y[0]; };

auto run(const stagecraft::orbit_guess<Vector2d>& guess) {
    return stagecraft::periodic_orbit(stagecraft::gauss<3>(), f, guess);
}
