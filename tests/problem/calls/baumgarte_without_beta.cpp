// SPDX-License-Identifier: BSL-1.0
// says: baumgarte(model, alpha, beta): give both rates
// says: alpha = beta damps critically: baumgarte(model, 10, 10)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return 9.81 * q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };

auto run() {
    const auto model = stagecraft::lagrangian<2, 1>(kinetic, potential, length);
#ifdef RIGHT
    const auto problem = stagecraft::baumgarte(model, 10, 10);
#else
    const auto problem = stagecraft::baumgarte(model, 10);
#endif
    const auto y0 = problem.initial_state(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 0));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
