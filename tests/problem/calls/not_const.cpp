// SPDX-License-Identifier: BSL-1.0
// says: the problem is const and its operator()(t, y, f) is not
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

struct decay {
    void operator()(double, const Vector2d& y, Vector2d& f) { f = -y; }
};
const decay problem;

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
