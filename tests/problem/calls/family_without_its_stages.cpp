// SPDX-License-Identifier: BSL-1.0
// says: stands in angle brackets, radau_iia<3>()
// lines: 15
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() { return stagecraft::integrate(stagecraft::radau_iia, problem, Vector2d(1, 1), 0, 1); }
