// SPDX-License-Identifier: BSL-1.0
// says: write [](const auto& t, const auto& y, auto& f) { name(t, y, f); }
// lines: 20
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

void decay(auto, const auto& y, auto& f) { f = -y; }

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), decay, Vector2d(1, 1), 0, 1); }
