// SPDX-License-Identifier: BSL-1.0
// says: radau_iia<3>(), or include stagecraft/families.hpp for radau_iia(3)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() { return stagecraft::integrate(stagecraft::radau_iia(3), problem, Vector2d(1, 1), 0, 1); }
