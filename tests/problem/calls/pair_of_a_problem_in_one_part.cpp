// SPDX-License-Identifier: BSL-1.0
// says: a pair of tableaux needs a problem in two parts: partition(f, g)
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/partitioned.hpp>

using Eigen::Vector4d, stagecraft::gauss, stagecraft::partitioned;

const auto f = [](double, const Vector4d& y, Vector4d& out) { out = -y; };

auto run() {
    return integrate(partitioned(gauss<2>(), gauss<2>()), f, Vector4d(1, 1, 0, 0), 0, 1, {.fixed_step = 0.1});
}
