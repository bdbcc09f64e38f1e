// SPDX-License-Identifier: BSL-1.0
// says: hamiltonian<n>: an energy must return a number, not a matrix or product of Eigen's
#include <stagecraft/partitioned.hpp>

const auto spring = stagecraft::hamiltonian<2>([](const auto& p) { return (p.transpose() * p).eval(); },
                                               [](const auto& q) { return q.norm(); });
