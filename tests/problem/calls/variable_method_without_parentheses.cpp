// SPDX-License-Identifier: BSL-1.0
// says: radau_iia_variable() with its parentheses
// lines: 8
#include <stagecraft/integrate.hpp>
#include <stagecraft/radau_iia_variable.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() { return stagecraft::integrate(stagecraft::radau_iia_variable, problem, Vector2d(1, 1), 0, 1); }
