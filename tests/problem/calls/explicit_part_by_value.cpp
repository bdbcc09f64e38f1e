// SPDX-License-Identifier: BSL-1.0
// says: f_explicit of split(f_explicit, f_implicit) must be callable as f(t, y, f), f by reference
// lines: 8
#include <stagecraft/additive.hpp>

using Eigen::Vector2d;

auto run(const stagecraft::tableau<double>& e, const stagecraft::tableau<double>& i) {
    const auto lost = [](double, const Vector2d& y, Vector2d f) { f = -y; };
    const auto kept = [](double, const Vector2d& y, Vector2d& f) { f = -y; };
    return stagecraft::integrate(stagecraft::additive(e, i), stagecraft::split(lost, kept), Vector2d(1, 1), 0,
                                 1);
}
