// SPDX-License-Identifier: BSL-1.0
// says: the constraint must return m rows
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return q[1]; };
const auto two_rows = [](const auto& q) { return q.eval(); };

auto model = stagecraft::lagrangian<2, 1>(kinetic, potential, two_rows);
