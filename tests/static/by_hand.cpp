// SPDX-License-Identifier: BSL-1.0
// The same reaction by the implicit Euler method with Eigen/Core and Eigen/LU alone: the least that a program
// without the library compiles.
#include <Eigen/Core>
#include <Eigen/LU>
#include <iostream>

int main() {
    Eigen::Vector3d y(1, 0, 0), f;
    Eigen::Matrix3d J;
    for (int step = 0; step < 4000; ++step) {
        const Eigen::Vector3d y0 = y;
        for (int k = 0; k < 5; ++k) {
            f << -0.04 * y[0] + 1e4 * y[1] * y[2], 0.04 * y[0] - 1e4 * y[1] * y[2] - 3e7 * y[1] * y[1],
                3e7 * y[1] * y[1];
            J << -0.04, 1e4 * y[2], 1e4 * y[1], 0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1], 0, 6e7 * y[1], 0;
            y -= (Eigen::Matrix3d::Identity() - 0.01 * J).partialPivLu().solve(y - y0 - 0.01 * f);
        }
    }
    std::cout << y.transpose() << '\n';
}
