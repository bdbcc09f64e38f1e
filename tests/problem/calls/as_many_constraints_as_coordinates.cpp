// SPDX-License-Identifier: BSL-1.0
// says: m must be less than n
// lines: 8
#include <stagecraft/mechanics/formulations.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const auto& q) { return 9.81 * q[1]; };
const auto fixed = [](const auto& q) { return q; };

auto run() { return stagecraft::index_2(stagecraft::lagrangian<2, 2>(T, V, fixed)); }
