// SPDX-License-Identifier: BSL-1.0
// says: stands in angle brackets, lobatto_iiia<3>()
// lines: 8
#include <stagecraft/coefficients/lobatto_iiia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    return stagecraft::integrate(stagecraft::lobatto_iiia, problem, Vector2d(1, 1), 0, 1, {.rtol = 1e-6});
}
