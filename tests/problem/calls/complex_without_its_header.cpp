// SPDX-License-Identifier: BSL-1.0
// says: with stagecraft/states.hpp it may be
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2cd;

const auto problem = [](double, const Vector2cd& y, Vector2cd& f) { f = -y; };

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2cd(1, 1), 0, 1); }
