// SPDX-License-Identifier: BSL-1.0
// says: hamiltonian<n>(H) or hamiltonian<n>(T, V): give n, the number of coordinates
#include <stagecraft/partitioned.hpp>

const auto spring =
    stagecraft::hamiltonian([](const auto& q, const auto& p) { return q.squaredNorm() + p.squaredNorm(); });
