// SPDX-License-Identifier: BSL-1.0
// says: must be callable as problem(t, y, f)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const auto& q) { return 9.81 * q[1]; };

auto run() {
    const auto problem = stagecraft::free_motion(stagecraft::lagrangian<2>(T, V));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Eigen::Vector2d(1, 0), 0, 1);
}
