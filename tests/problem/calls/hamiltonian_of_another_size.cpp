// SPDX-License-Identifier: BSL-1.0
// says: hamiltonian<n>: y0 = (q, p) must have 2 n components
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/partitioned.hpp>

using Eigen::Vector4d, stagecraft::gauss, stagecraft::partitioned;

const auto spring = stagecraft::hamiltonian<3>(
    [](const auto& q, const auto& p) { return q.squaredNorm() + p.squaredNorm(); });

auto run() {
    return integrate(partitioned(gauss<2>(), gauss<2>()), spring, Vector4d(1, 1, 0, 0), 0, 1,
                     {.fixed_step = 0.1});
}
