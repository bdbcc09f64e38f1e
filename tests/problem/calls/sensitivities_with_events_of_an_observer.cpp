// SPDX-License-Identifier: BSL-1.0
// says: without events<Vector>() and observers() around
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d, stagecraft::radau_iia;

const auto problem = [](const auto&, const auto& y, const auto& p, auto& out) {
    out[0] = y[1], out[1] = -p[0];
};
const auto bounces = stagecraft::events<Vector2d>(stagecraft::event(
    [](double, const Vector2d& y) { return y[0]; }, {}, [](double, Vector2d& y) { y[1] *= -1; }));

auto run() {
    return stagecraft::sensitivities(radau_iia<3>(), problem, Vector2d(1, 0), Vector2d(1, 0), 0, 1, {},
                                     nullptr, bounces);
}
