// SPDX-License-Identifier: BSL-1.0
// says: dual_number
// lines: 16
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](auto, const auto& y, auto& f) {
    const double rate = 2 * y[0];
    f[0] = rate * y[1];
    f[1] = 0 * y[1];
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
