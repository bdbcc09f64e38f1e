// SPDX-License-Identifier: BSL-1.0
// says: must be callable as problem(t, y, p, f)
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d, stagecraft::radau_iia;

const auto problem = [](const auto&, const auto& y, auto& out) { out[0] = -y[0], out[1] = y[0]; };

auto run() {
    return stagecraft::sensitivities(radau_iia<3>(), problem, Vector2d(1, 0), Vector2d(1, 1), 0, 1);
}
