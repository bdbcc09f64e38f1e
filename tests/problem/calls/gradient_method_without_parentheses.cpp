// SPDX-License-Identifier: BSL-1.0
// says: radau_iia<3>() with its parentheses
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/adjoint.hpp>

using Eigen::Vector2d, stagecraft::radau_iia;

const auto problem = [](const auto&, const auto& y, const auto& p, auto& out) {
    out[0] = -p[0] * y[0], out[1] = p[0] * y[0];
};
const auto end = [](const auto& y) { return y[1]; };

auto run() {
    return stagecraft::adjoint_gradient(radau_iia<3>, problem, Vector2d(1, 0), Vector2d(1, 1), 0, 1, end);
}
