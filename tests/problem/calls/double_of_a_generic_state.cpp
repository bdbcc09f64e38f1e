// SPDX-License-Identifier: BSL-1.0
// says: dual_number
// lines: 16
// lines of g++: 6
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const auto& y, auto& f) {
#ifdef RIGHT
    const auto k = y[0];
#else
    const double k = y[0];
#endif
    f[0] = -k;
    f[1] = 0;
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
