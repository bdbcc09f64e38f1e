// SPDX-License-Identifier: BSL-1.0
// says: with a checkpoint in place of y0, t0
// lines: 11
#include <stagecraft/checkpoint.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run(const stagecraft::checkpoint<Vector2d>& from) {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, from, 1, {.hmax = 0.1});
}
