// SPDX-License-Identifier: BSL-1.0
// says: tgamma and lgamma are not differentiated automatically
// lines: 12
#include <cmath>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

#ifdef RIGHT
const auto problem = [](double, const Vector2d& y, Vector2d& f) {
#else
const auto problem = [](auto, const auto& y, auto& f) {
#endif
    f[0] = -std::tgamma(y[0]);
    f[1] = 0;
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
