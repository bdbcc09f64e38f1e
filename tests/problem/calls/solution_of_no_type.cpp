// SPDX-License-Identifier: BSL-1.0
// says: write solution<Eigen::Vector3d> y, with the type of the state
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/solution.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    stagecraft::solution y;
    stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, y);
    return y(0.5)[0];
}
