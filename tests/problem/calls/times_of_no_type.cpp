// SPDX-License-Identifier: BSL-1.0
// says: write output_times<Eigen::Vector3d> table({0, 1}), with the type of the state
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/output_times.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    stagecraft::output_times table({0, 0.5, 1});
    stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, table);
    return table.y(1)[0];
}
