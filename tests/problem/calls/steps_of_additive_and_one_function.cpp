// SPDX-License-Identifier: BSL-1.0
// says: steps: an additive method and a problem split(f_explicit, f_implicit) belong together
// lines: 8
#include <stagecraft/additive.hpp>
#include <stagecraft/steps.hpp>

using Eigen::Vector2d;

void run(const stagecraft::tableau<double>& e, const stagecraft::tableau<double>& i) {
    const auto f = [](double, const Vector2d& y, Vector2d& f) { f = -y; };
    stagecraft::steps(stagecraft::additive(e, i), f, Vector2d(1, 1), 0, 1);
}
