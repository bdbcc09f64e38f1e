// SPDX-License-Identifier: BSL-1.0
// says: atol_components (an Eigen::VectorXd or {1e-6, 1e-9})
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1,
                                 {.atol = Vector2d(1e-6, 1e-9)});
}
