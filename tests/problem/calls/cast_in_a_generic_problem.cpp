// SPDX-License-Identifier: BSL-1.0
// says: keep what follows from y as `auto k = y[0];`
// lines: 12
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](auto, const auto& y, auto& f) {
#ifdef RIGHT
    const auto k = y[0];
#else
    const auto k = static_cast<double>(y[0]);
#endif
    f[0] = -k;
    f[1] = 0;
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
