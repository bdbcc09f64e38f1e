// SPDX-License-Identifier: BSL-1.0
// says: the problem is split(f_explicit, f_implicit), which additive(explicit_part, implicit_part) takes
// lines: 8
#include <stagecraft/additive.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>

using Eigen::Vector2d;

auto run() {
    const auto f = [](double, const Vector2d& y, Vector2d& f) { f = -y; };
    return stagecraft::integrate(stagecraft::radau_iia<2>(), stagecraft::split(f, f), Vector2d(1, 1), 0, 1);
}
