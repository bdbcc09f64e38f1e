// SPDX-License-Identifier: BSL-1.0
// says: initial_state(q, v): the size of v must be n, the number of coordinates of the model
// lines: 9
// lines of g++: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return 9.81 * q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };
#ifdef RIGHT
const Eigen::Vector2d v(0, 0);
#else
const Eigen::Vector3d v(0, 0, 0);
#endif

auto run() {
    const auto problem =
        stagecraft::stabilised_index_2(stagecraft::lagrangian<2, 1>(kinetic, potential, length));
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), v, 0);
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
