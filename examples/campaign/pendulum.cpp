// SPDX-License-Identifier: BSL-1.0
// The pendulum of length 1 in Cartesian coordinates, index 3, swinging or turning over for 10 seconds.
#include <memory>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/solution.hpp>

#include "problem.hpp"

namespace campaign {

/// q' = v, v' = (0, -g) - 2 q lambda, 0 = |q|^2 - 1, from a random angle and speed. The reference is the angle's
/// own equation, theta'' = -g sin theta, by s = 7 at 1e-14; lambda follows from it.
problem pendulum(dice d) {
    problem p;
    constexpr double g = 9.81;
    // Not near the upright position at rest, where any error grows to a swing or a turn.
    Eigen::Vector2d start;
    do start = Eigen::Vector2d(d.between(-3, 3), d.between(-8, 8));
    while (std::abs(start[1] * start[1] / 2 - g * std::cos(start[0]) - g) < g / 2);
    using angle = Eigen::Vector2d;
    const auto swing = std::make_shared<stagecraft::solution<angle>>();
    p.t1 = 10;
    const auto reference = stagecraft::integrate(
        stagecraft::radau_iia<7>(),
        [](const auto&, const auto& y, auto& f) {
            using std::sin;
            f[0] = y[1];
            f[1] = -g * sin(y[0]);
        },
        start, 0, p.t1, {.rtol = 1e-14, .atol = 1e-14, .max_step = 0.05}, *swing);
    if (!reference.ok()) throw std::runtime_error("campaign: the pendulum's reference failed");
    p.exact = [swing](double t) {
        const angle a = (*swing)(t);
        const double s = std::sin(a[0]), c = std::cos(a[0]), w = a[1];
        VectorXd y(5);
        y << s, -c, c * w, s * w, (w * w + g * c) / 2;  // v^2 + q.(0, -g) - 2 lambda = 0
        return y;
    };
    p.y0 = p.exact(0);
    p.differential = 4;
    p.index = {1, 1, 2, 2, 3};
    p.f = [](double, const VectorXd& y, VectorXd& f) {
        f << y[2], y[3], -2 * y[0] * y[4], -g - 2 * y[1] * y[4], y[0] * y[0] + y[1] * y[1] - 1;
    };
    p.jacobian = [](double, const VectorXd& y, MatrixXd& J) {
        J << 0, 0, 1, 0, 0,                 //
            0, 0, 0, 1, 0,                  //
            -2 * y[4], 0, 0, 0, -2 * y[0],  //
            0, -2 * y[4], 0, 0, -2 * y[1],  //
            2 * y[0], 2 * y[1], 0, 0, 0;
    };
    p.description = "angle " + std::to_string(start[0]) + ", speed " + std::to_string(start[1]);
    return p;
}

}  // namespace campaign
