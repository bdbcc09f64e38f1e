// SPDX-License-Identifier: BSL-1.0
// says: the problem must be callable as problem(t, y, p, f)
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d;

const auto f = [](auto& out, const auto& y, const auto& p, auto) {
    out[0] = -p[0] * y[0], out[1] = p[1] * y[0];
};

auto run() {
    return stagecraft::sensitivities(stagecraft::radau_iia<3>(), f, Vector2d(1, 0), Vector2d(1, 2), 0, 1);
}
