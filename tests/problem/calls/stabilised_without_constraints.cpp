// SPDX-License-Identifier: BSL-1.0
// says: stabilised_index_2: the model has no constraints: take free_motion(model)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const auto& q) { return 9.81 * q[1]; };

auto run() {
    const auto problem = stagecraft::stabilised_index_2(stagecraft::lagrangian<2>(T, V));
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
