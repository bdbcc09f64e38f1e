// SPDX-License-Identifier: BSL-1.0
// says: method and y0 must have the same scalar type
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](auto, const auto& y, auto& f) { f = -y; };

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Eigen::Vector2f(1, 1), 0, 1); }
