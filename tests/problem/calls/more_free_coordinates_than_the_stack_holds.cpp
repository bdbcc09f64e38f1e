// SPDX-License-Identifier: BSL-1.0
// says: n is too large
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const auto& q) { return 9.81 * q[1]; };

auto run() {
    const auto problem = stagecraft::free_motion(stagecraft::lagrangian<30>(T, V));
    using vector = Eigen::Matrix<double, 30, 1>;
    const auto y0 = problem.initial_state(vector::Unit(0), vector::Zero());
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
