// SPDX-License-Identifier: BSL-1.0
// says: return a vector of n numbers
// lines: 8
#include <stagecraft/mechanics/free_motion.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };
const auto damping = [](const auto&, const auto& v, const auto&) { return -0.1 * v[0]; };

auto model = stagecraft::free_motion(stagecraft::lagrangian<2>(kinetic, potential, damping));
