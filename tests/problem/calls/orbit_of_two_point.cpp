// SPDX-License-Identifier: BSL-1.0
// says: periodic_orbit(method, f, guess, options): f is called as f(t, y, out)
// lines: 11
#include <stagecraft/bvp/periodic_orbit.hpp>
#include <stagecraft/coefficients/gauss.hpp>

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };
const auto r = [](const auto& left, const auto& right, auto& out) {
    out[0] = left[0], out[1] = right[0] - 1;
};

auto run(const stagecraft::orbit_guess<Eigen::Vector2d>& guess) {
    return stagecraft::periodic_orbit(stagecraft::gauss<3>(), stagecraft::two_point(f, r), guess);
}
