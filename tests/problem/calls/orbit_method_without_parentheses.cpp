// SPDX-License-Identifier: BSL-1.0
// says: gauss<3>() with its parentheses
// lines: 11
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/coefficients/gauss.hpp>

using Eigen::Vector2d, stagecraft::gauss;

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };

auto run() { return stagecraft::periodic_orbit(gauss<3>, f, stagecraft::orbit_guess<Vector2d>()); }
