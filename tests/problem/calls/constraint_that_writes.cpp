// SPDX-License-Identifier: BSL-1.0
// says: the constraint must be callable as g(q) or g(q, t) and return its values
// lines: 8
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const auto& q) { return 9.81 * q[1]; };
#ifdef RIGHT
const auto g = [](const auto& q) { return q.squaredNorm() - 1; };
#else
const auto g = [](const auto& q, auto& out) { out[0] = q.squaredNorm() - 1; };
#endif

auto run() { return stagecraft::stabilised_index_2(stagecraft::lagrangian<2, 1>(T, V, g)); }
