// SPDX-License-Identifier: BSL-1.0
// says: problem.bandwidth must be a member function `stagecraft::bandwidth bandwidth() const`
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/banded_blocks.hpp>

using Eigen::Vector2d;

struct problem {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    int bandwidth() const { return 1; }
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem{}, Vector2d(1, 1), 0, 1); }
