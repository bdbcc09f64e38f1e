// SPDX-License-Identifier: BSL-1.0
// says: write [&](auto point) { last = std::move(point); } in place of last
// lines: 8
#include <stagecraft/checkpoint.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/save_every.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    stagecraft::checkpoint<Vector2d> last;
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {},
                                 stagecraft::save_every(100, last));
}
