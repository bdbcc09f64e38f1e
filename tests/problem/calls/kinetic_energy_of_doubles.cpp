// SPDX-License-Identifier: BSL-1.0
// says: T, V, Q and the constraint must accept vectors of any scalar
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

using Eigen::Vector2d;

const auto T = [](const Vector2d&, const Vector2d& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const Vector2d& q) { return 9.81 * q[1]; };

auto run() {
    return stagecraft::integrate(stagecraft::radau_iia<3>(),
                                 stagecraft::free_motion(stagecraft::lagrangian<2>(T, V)),
                                 Eigen::Vector4d(1, 0, 0, 0), 0, 1);
}
