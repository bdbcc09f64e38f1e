// SPDX-License-Identifier: BSL-1.0
// says: stands in angle brackets, radau_iia<3>()
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d, stagecraft::sensitivities;

const auto f = [](const auto&, const auto& y, const auto& p, auto& out) { out = -p[0] * y; };

auto run() { return sensitivities(stagecraft::radau_iia, f, Vector2d(1, 1), Vector2d(2, 0), 0, 1); }
