// SPDX-License-Identifier: BSL-1.0
// says: the kinetic energy must be callable as T(q, v), and comes before the potential energy V(q)
// lines: 8
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };

auto model = stagecraft::free_motion(stagecraft::lagrangian<2>(potential, kinetic));
