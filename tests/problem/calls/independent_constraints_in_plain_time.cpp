// SPDX-License-Identifier: BSL-1.0
// says: independent_constraints<rank>(constraint, q): the constraint must take t of any scalar as well
// lines: 8
#include <stagecraft/mechanics/independent_constraints.hpp>

#ifdef RIGHT
const auto twice = [](const auto& q, const auto& t) { return ((1 + t) * q).eval(); };
#else
const auto twice = [](const auto& q, double t) { return ((1 + t) * q).eval(); };
#endif

auto run() { return stagecraft::independent_constraints<2>(twice, Eigen::Vector2d(1, 0)); }
