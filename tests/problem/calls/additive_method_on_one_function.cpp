// SPDX-License-Identifier: BSL-1.0
// says: an additive method takes a problem in two parts: write split(f_explicit, f_implicit)
// lines: 8
#include <stagecraft/additive.hpp>

using Eigen::Vector2d;

auto run(const stagecraft::tableau<double>& e, const stagecraft::tableau<double>& i) {
    const auto f = [](double, const Vector2d& y, Vector2d& f) { f = -y; };
    return stagecraft::integrate(stagecraft::additive(e, i), f, Vector2d(1, 1), 0, 1);
}
