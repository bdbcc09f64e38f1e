// SPDX-License-Identifier: BSL-1.0
// says: radau_iia<3>() with its parentheses
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/last_return.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() { return stagecraft::last_return(stagecraft::radau_iia<3>, problem, Vector2d(1, 0), 0, 60); }
