// SPDX-License-Identifier: BSL-1.0
// says: all callable with vectors of n numbers of any type, as they are differentiated automatically
#include <stagecraft/partitioned.hpp>

using Eigen::Vector2d;
const auto spring = stagecraft::hamiltonian<2>([](const Vector2d& q) { return q.norm(); },
                                               [](const Vector2d& p) { return p.norm(); });
