// SPDX-License-Identifier: BSL-1.0
// says: Problem::linear_solver must be a type
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

struct problem {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    int linear_solver = 0;
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem{}, Vector2d(1, 1), 0, 1); }
