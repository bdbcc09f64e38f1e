// SPDX-License-Identifier: BSL-1.0
// says: the problem must be callable as problem(t, y, p, f)
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d, stagecraft::radau_iia;

auto run() {
    const auto f = [](double, const Vector2d& y, const Vector2d& p) { return Vector2d(-p[0] * y); };
    return stagecraft::sensitivities(radau_iia<3>(), f, Vector2d(1, 1), Vector2d(2, 0), 0, 1);
}
