// SPDX-License-Identifier: BSL-1.0
// says: lagrangian: the generalised forces must take t of any scalar as well
// lines: 11
// lines of g++: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return 9.81 * q[1]; };
#ifdef RIGHT
const auto drive = [](const auto&, const auto& v, const auto& t) { return (t * v).eval(); };
#else
const auto drive = [](const auto&, const auto& v, double t) { return (t * v).eval(); };
#endif

auto run() {
    const auto problem = stagecraft::free_motion(stagecraft::lagrangian<2>(kinetic, potential, drive));
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
