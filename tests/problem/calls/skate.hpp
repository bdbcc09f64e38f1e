// SPDX-License-Identifier: BSL-1.0
// A model that has a constraint of velocity and none of position: a skate on a slope moves along its blade.
#pragma once

#include <stagecraft/mechanics/lagrangian.hpp>

inline const auto skate =
    stagecraft::lagrangian<2, 1>([](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); },
                                 [](const auto& q) { return 9.81 * q[1]; },
                                 [](const auto& q) {
                                     auto G = (0 * q).transpose().eval();
                                     G(0) = 1;
                                     return G;
                                 });
