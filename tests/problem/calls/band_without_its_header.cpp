// SPDX-License-Identifier: BSL-1.0
// says: include stagecraft/linear/banded_blocks.hpp
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

struct banded {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    stagecraft::bandwidth bandwidth() const { return {0, 0}; }
};
const banded problem;

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
