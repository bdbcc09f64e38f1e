// SPDX-License-Identifier: BSL-1.0
// says: the constraint must return m rows
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };
const auto two_rows = [](const auto& q) { return q.template head<2>().eval(); };

auto run() {
    const auto model = stagecraft::lagrangian<3, 1>(kinetic, potential, two_rows);
    const auto problem = stagecraft::stabilised_index_2(model);
    const auto y0 = problem.initial_state(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 1));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
