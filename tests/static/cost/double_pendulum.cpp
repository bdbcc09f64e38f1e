// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

int main() {  // two unit masses on rods of length 1, by the angles from the vertical
    const auto T = [](const auto& q, const auto& v) {
        using std::cos;
        return v[0] * v[0] + 0.5 * v[1] * v[1] + v[0] * v[1] * cos(q[0] - q[1]);
    };
    const auto V = [](const auto& q) {
        using std::cos;
        return -9.81 * (2 * cos(q[0]) + cos(q[1]));
    };
    const auto pendulum = stagecraft::free_motion(stagecraft::lagrangian<2>(T, V));
    const auto r = stagecraft::integrate(
        stagecraft::radau_iia<3>(), pendulum,
        pendulum.initial_state(Eigen::Vector2d(1.1, -0.4), Eigen::Vector2d(2, -3)), 0.0, 3.0);
    std::printf("%.6f\n", r.y[0]);
}
