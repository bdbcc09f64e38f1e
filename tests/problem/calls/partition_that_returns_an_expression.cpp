// SPDX-License-Identifier: BSL-1.0
// says: returns an expression of Eigen's, whose operands may be gone before it is evaluated
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/partitioned.hpp>

using Eigen::Vector4d, stagecraft::gauss, stagecraft::partitioned;

const auto spring = stagecraft::partition([](double, const auto& p) { return 2 * p; },
                                          [](double, const auto& q) { return -q; });

auto run() {
    return integrate(partitioned(gauss<2>(), gauss<2>()), spring, Vector4d(1, 1, 0, 0), 0, 1,
                     {.fixed_step = 0.1});
}
