// SPDX-License-Identifier: BSL-1.0
// says: the first argument must be a transformed_tableau or a variable_order set
// lines: 11
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d, stagecraft::lobatto_iiia;

const auto f = [](const auto&, const auto& y, const auto& p, auto& out) { out = -p[0] * y; };

auto run() { return stagecraft::sensitivities(lobatto_iiia<3>(), f, Vector2d(1, 1), Vector2d(2, 0), 0, 1); }
