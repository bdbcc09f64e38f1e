// SPDX-License-Identifier: BSL-1.0
// says: the generalised forces must be callable as Q(q, v, t)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };
#ifdef RIGHT
const auto damping = [](const auto&, const auto& v, const auto&) { return (-0.1 * v).eval(); };
#else
const auto damping = [](const auto&, const auto& v) { return (-0.1 * v).eval(); };
#endif

auto run() {
    const auto problem =
        stagecraft::stabilised_index_2(stagecraft::lagrangian<2, 1>(kinetic, potential, length, damping));
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
