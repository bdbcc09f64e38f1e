// SPDX-License-Identifier: BSL-1.0
// says: the m constraints g are missing
// lines: 8
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };

auto run() { return stagecraft::free_motion(stagecraft::lagrangian<2, 1>(kinetic, potential)); }
