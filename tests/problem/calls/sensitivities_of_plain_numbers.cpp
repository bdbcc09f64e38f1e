// SPDX-License-Identifier: BSL-1.0
// says: must be generic in its scalar
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d, stagecraft::radau_iia;

const auto f = [](double, const Vector2d& y, const Vector2d& p, Vector2d& out) { out = -p[0] * y; };

auto run() { return stagecraft::sensitivities(radau_iia<3>(), f, Vector2d(1, 1), Vector2d(2, 0), 0, 1); }
