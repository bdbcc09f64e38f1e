// SPDX-License-Identifier: BSL-1.0
// says: the observer must be callable as observer(t, y)
// lines: 20
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
#ifdef RIGHT
    const auto low = [](auto t, const auto& y) { return y[0] < t; };
#else
    const auto low = [](const auto& y, auto t) { return y[0] < t; };
#endif
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, low);
}
