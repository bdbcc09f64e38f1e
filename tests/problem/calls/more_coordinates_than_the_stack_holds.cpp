// SPDX-License-Identifier: BSL-1.0
// says: n is too large
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };

auto run() {
    const auto problem = stagecraft::index_2(stagecraft::lagrangian<40, 1>(kinetic, potential, length));
    using vector = Eigen::Matrix<double, 40, 1>;
    const auto y0 = problem.initial_state(vector::Unit(0), vector::Zero());
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}
