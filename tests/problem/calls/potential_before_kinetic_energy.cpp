// SPDX-License-Identifier: BSL-1.0
// says: the kinetic energy must be callable as T(q, v), and comes before the potential energy V(q)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };

auto run() {
#ifdef RIGHT
    const auto model = stagecraft::lagrangian<2, 1>(kinetic, potential, length);
#else
    const auto model = stagecraft::lagrangian<2, 1>(potential, kinetic, length);
#endif
    const auto problem = stagecraft::stabilised_index_2(model);
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
