// SPDX-License-Identifier: BSL-1.0
// says: lagrangian: T and V must return a number, not a matrix or product of Eigen's: write 0.5 * v.dot(M * v), or (0.5 * v.transpose() * M * v).value()
// lines: 8
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
#ifdef RIGHT
const auto potential = [](const auto& q) { return (9.81 * q.segment(1, 1)).value(); };
#else
const auto potential = [](const auto& q) { return 9.81 * q.segment(1, 1); };
#endif

auto model = stagecraft::lagrangian<2>(kinetic, potential);
