// SPDX-License-Identifier: BSL-1.0
// says: partition(f, g): g must be callable as g(t, q) or g(t, q, p), q and p of half the size
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/partitioned.hpp>

using Eigen::Vector4d, stagecraft::gauss, stagecraft::partitioned;

using Eigen::Vector2d, Eigen::Vector3d;
const auto spring = stagecraft::partition([](double, const Vector2d& p) -> Vector2d { return p; },
                                          [](Vector3d q) -> Vector3d { return -q; });

auto run() {
    return integrate(partitioned(gauss<2>(), gauss<2>()), spring, Vector4d(1, 1, 0, 0), 0, 1,
                     {.fixed_step = 0.1});
}
