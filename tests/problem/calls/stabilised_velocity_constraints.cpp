// SPDX-License-Identifier: BSL-1.0
// says: take index_2(model)
// lines: 8
#include <stagecraft/mechanics/holonomic.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto V = [](const auto& q) { return 9.81 * q[1]; };
const auto blade = [](const auto& q) {
    auto G = (0 * q).transpose().eval();
    G(0) = 1;
    return G;
};

auto run() { return stagecraft::stabilised_index_2(stagecraft::lagrangian<2, 1>(T, V, blade)); }
