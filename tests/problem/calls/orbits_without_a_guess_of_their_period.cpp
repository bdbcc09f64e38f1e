// SPDX-License-Identifier: BSL-1.0
// says: guess must be an orbit_guess
// lines: 11
#include <stagecraft/bvp/orbit_continuation.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d, stagecraft::gauss;

const auto f = [](const auto&, const auto& y, const auto& p, auto& out) {
    out[0] = y[1], out[1] = -p[0] * y[0];
};

auto run() { return stagecraft::orbit_continuation(gauss<3>(), f, Vector2d(0, 1)); }
