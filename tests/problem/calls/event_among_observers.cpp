// SPDX-License-Identifier: BSL-1.0
// says: the observer must be callable as observer(t, y)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>
#include <stagecraft/observe/observers.hpp>
#include <stagecraft/observe/solution.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    stagecraft::solution<Vector2d> kept;
    const auto height = stagecraft::event([](double, const Vector2d& y) { return y[0]; });
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {},
                                 stagecraft::observers(height, kept));
}
