// SPDX-License-Identifier: BSL-1.0
// The program whose compile time and includes are budgeted: the README's first one.
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

int main() {
    const auto robertson = [](double, const Eigen::Vector3d& y, Eigen::Vector3d& f) {
        f << -0.04 * y[0] + 1e4 * y[1] * y[2], 0.04 * y[0] - 1e4 * y[1] * y[2] - 3e7 * y[1] * y[1],
            3e7 * y[1] * y[1];
    };
    const auto r = stagecraft::integrate(stagecraft::radau_iia<3>(), robertson, Eigen::Vector3d(1, 0, 0), 0.0,
                                         40.0, {.rtol = 1e-8, .atol = 1e-12});
    std::cout << name(r.status) << " at t = " << r.t << ": " << r.y.transpose() << '\n';
}
