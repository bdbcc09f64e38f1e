// SPDX-License-Identifier: BSL-1.0
// says: orbit_continuation(method, f, guess, options): f is called as f(t, y, p, out)
// lines: 11
#include <stagecraft/bvp/orbit_continuation.hpp>
#include <stagecraft/coefficients/gauss.hpp>

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };

auto run(const stagecraft::orbit_guess<Eigen::Vector2d>& guess) {
    return stagecraft::orbit_continuation(stagecraft::gauss<3>(), f, guess, {.from = 1, .to = 2});
}
