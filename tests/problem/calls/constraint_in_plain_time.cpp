// SPDX-License-Identifier: BSL-1.0
// says: lagrangian: the constraint must take t of any scalar as well
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return 9.81 * q[1]; };
#ifdef RIGHT
const auto rod = [](const auto& q, const auto& t) { return q.squaredNorm() - 1 - t; };
#else
const auto rod = [](const auto& q, double t) { return q.squaredNorm() - 1 - t; };
#endif

auto run() {
    const auto problem = stagecraft::index_2(stagecraft::lagrangian<2, 1>(kinetic, potential, rod));
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0.5, 0));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
