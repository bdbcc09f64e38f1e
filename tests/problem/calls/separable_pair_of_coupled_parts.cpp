// SPDX-License-Identifier: BSL-1.0
// says: the order of this pair holds for separable problems alone: partition(f, g) of f(t, p) and g(t, q)
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/partitioned.hpp>

using Eigen::Vector4d, stagecraft::gauss, stagecraft::partitioned;

const auto H = stagecraft::hamiltonian<2>(
    [](const auto& q, const auto& p) { return q.squaredNorm() * p.squaredNorm(); });

auto run() {
    return integrate(stagecraft::separable(gauss<2>(), gauss<2>()), H, Vector4d(1, 1, 0, 0), 0, 1,
                     {.fixed_step = 0.1});
}
