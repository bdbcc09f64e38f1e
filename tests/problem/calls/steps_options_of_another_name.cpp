// SPDX-License-Identifier: BSL-1.0
// says: options have the names that they have for integrate()
// lines: 11
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/steps.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    return stagecraft::steps(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {.tol = 1e-9});
}
