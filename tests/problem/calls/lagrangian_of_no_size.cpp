// SPDX-License-Identifier: BSL-1.0
// says: give n, the number of coordinates, and m, that of constraints
// lines: 8
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const auto& q) { return 9.81 * q[1]; };
const auto rod = [](const auto& q) { return q.squaredNorm() - 1; };

auto run() { return stagecraft::stabilised_index_2(stagecraft::lagrangian(T, V, rod)); }
