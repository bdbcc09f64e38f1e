// SPDX-License-Identifier: BSL-1.0
// says: free_motion: the model has constraints
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const auto& q) { return 9.81 * q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };

auto run() {
    const auto problem = stagecraft::free_motion(stagecraft::lagrangian<2, 1>(T, V, length));
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
