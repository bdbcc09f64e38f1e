// SPDX-License-Identifier: BSL-1.0
// says: vectors as `std::decay_t<decltype(y)> g = y;`
// lines: 21
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](auto, const auto& y, auto& f) {
#ifdef RIGHT
    const std::decay_t<decltype(y)> g = -y;
#else
    const Vector2d g = y;
#endif
    f = -g;
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
