// SPDX-License-Identifier: BSL-1.0
// says: give m, the number of constraints
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };

auto run() {
    const auto problem =
        stagecraft::stabilised_index_2(stagecraft::lagrangian<2>(kinetic, potential, length));
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
