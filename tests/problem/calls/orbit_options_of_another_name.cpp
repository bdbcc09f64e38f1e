// SPDX-License-Identifier: BSL-1.0
// says: no other names than {.rtol, .atol, .intervals
// lines: 11
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d;

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };

auto run(const stagecraft::orbit_guess<Vector2d>& guess) {
    return stagecraft::periodic_orbit(stagecraft::gauss<3>(), f, guess, {.tol = 1e-8});
}
