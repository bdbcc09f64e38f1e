// SPDX-License-Identifier: BSL-1.0
// says: the state holds two parts of the same size, (q, p) or (q, v): y0 must have an even number of components
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/partitioned.hpp>

using Eigen::Vector4d, stagecraft::gauss, stagecraft::partitioned;

const auto spring = stagecraft::partition([](double, const auto& p) { return p.eval(); },
                                          [](double, const auto& q) { return (-q).eval(); });

auto run() {
    return integrate(partitioned(gauss<2>(), gauss<2>()), spring, Eigen::Vector3d(1, 1, 0), 0, 1,
                     {.fixed_step = 0.1});
}
