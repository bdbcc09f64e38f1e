// SPDX-License-Identifier: BSL-1.0
// says: several observers are given as one, observers(a, b)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

const auto look = [](double, const Vector2d&) {};

auto run() {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, look, look);
}
