// SPDX-License-Identifier: BSL-1.0
// A nonholonomic model: a skate on a slope that must not slip sideways, a constraint of velocity that no constraint of
// position can replace. Turning at a constant rate it does not come down the slope at all, it drifts across.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

int main() {
    using namespace stagecraft;
    using Eigen::Vector3d;
    const double pull = 2, turning = 1.5;  // g sin(slope), and the rate of turning
    // q = (down the slope, across it, direction); mass 1, moment of inertia 1/10.
    const auto T = [](const auto&, const auto& v) {
        return 0.5 * (v[0] * v[0] + v[1] * v[1] + 0.1 * v[2] * v[2]);
    };
    const auto V = [=](const auto& q) { return -pull * q[0]; };
    const auto no_slip = [](const auto& q) {  // one row for each constraint: G(q) q' = 0
        using std::cos, std::sin;
        auto G = (0 * q).transpose().eval();
        G << sin(q[2]), -cos(q[2]), 0 * q[0];
        return G;
    };
    const auto skate = index_2(lagrangian<3, 1>(T, V, no_slip));

    const double t = 5;
    const auto r =
        integrate(radau_iia<3>(), skate, skate.initial_state(Vector3d(0, 0, 0), Vector3d(0, 0, turning)), 0,
                  t, {.rtol = 1e-9, .atol = 1e-9});
    const double turned = turning * t, unit = pull / (2 * turning * turning);
    std::cout << name(r.status) << std::fixed << std::setprecision(6) << "\ndown   " << r.y[0] << ", exact "
              << unit * std::pow(std::sin(turned), 2) << "\nacross " << r.y[1] << ", exact "
              << unit * (turned - std::sin(2 * turned) / 2) << "\nforce of the constraint "
              << std::setprecision(4) << std::abs(skate.multiplier(r.y)[0]) << ", exact "
              << std::abs(2 * pull * std::sin(turned)) << '\n';
}
