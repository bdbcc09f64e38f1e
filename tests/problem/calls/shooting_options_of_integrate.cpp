// SPDX-License-Identifier: BSL-1.0
// says: shooting(method, two_point(f, r), a, b, guess, options): options have no other names
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/shooting.hpp>

using Eigen::Vector2d, stagecraft::two_point;

const auto f = [](const auto&, const auto& y, auto& out) { out[0] = y[1], out[1] = -y[0]; };
const auto r = [](const auto& left, const auto& right, auto& out) {
    out[0] = left[0], out[1] = right[0] - 1;
};

auto run() {
    return stagecraft::shooting(stagecraft::radau_iia<3>(), two_point(f, r), 0, 1, Vector2d(0, 0),
                                {.max_step = 0.1});
}
