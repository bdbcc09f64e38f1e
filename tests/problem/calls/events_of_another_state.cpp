// SPDX-License-Identifier: BSL-1.0
// says: and of the type of y0
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>

using Eigen::Vector2d, Eigen::Vector3d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    auto watch =
        stagecraft::events<Vector3d>(stagecraft::event([](double, const Vector3d& y) { return y[0]; }));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, watch);
}
