// SPDX-License-Identifier: BSL-1.0
// The pendulum of length 1 in Cartesian coordinates, index 3, swinging or turning over for 10 seconds.
#include "problem.hpp"

namespace campaign {

/// q' = v, v' = (0, -g) - 2 q lambda, 0 = |q|^2 - 1, from a random angle and speed. Errors of the phase grow along
/// the run: every step is compared with the consistent state at the angle and angular velocity reached.
problem pendulum(dice d) {
    problem p;
    constexpr double g = 9.81;
    const auto state = [](double angle, double w) {
        const double s = std::sin(angle), c = std::cos(angle);
        VectorXd y(5);
        y << s, -c, c * w, s * w, (w * w + g * c) / 2;  // v^2 + q.(0, -g) - 2 lambda = 0
        return y;
    };
    const double angle = d.between(-3, 3), speed = d.between(-8, 8);
    p.t1 = 10;
    p.y0 = state(angle, speed);
    p.consistent = [state](const VectorXd& y) {
        const double size = std::hypot(y[0], y[1]);
        return state(std::atan2(y[0], -y[1]), (y[0] * y[3] - y[1] * y[2]) / (size * size));
    };
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
    p.description = "angle " + std::to_string(angle) + ", speed " + std::to_string(speed);
    return p;
}

}  // namespace campaign
