// SPDX-License-Identifier: BSL-1.0
// says: events<Vector2d>(event(g)), with the type of the state
// lines: 25
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/event.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    auto watch =
        stagecraft::events<double>(stagecraft::event([](double, const Vector2d& y) { return y[0]; }));
    stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {}, watch);
    return watch.found().size();
}
