// SPDX-License-Identifier: BSL-1.0
// says: gauss_variable() is of solve_bvp alone
// lines: 11
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/gauss_variable.hpp>

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };

auto run(const stagecraft::orbit_guess<Eigen::Vector2d>& guess) {
    return stagecraft::periodic_orbit(stagecraft::gauss_variable(), f, guess);
}
