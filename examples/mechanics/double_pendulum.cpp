// SPDX-License-Identifier: BSL-1.0
// Two unit masses on massless rods of length 1, in Cartesian coordinates, let go horizontally.
#include <stagecraft/mechanics/lagrangian.hpp>

#include "body.hpp"

namespace mechanics {

body double_pendulum() {
    const auto T = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
    const auto V = [](const auto& q) { return 9.81 * (q[1] + q[3]); };
    const auto rods = [](const auto& q) {
        auto g = (0 * q.template head<2>()).eval();
        g[0] = q.template head<2>().squaredNorm() - 1;
        g[1] = (q.template tail<2>() - q.template head<2>()).squaredNorm() - 1;
        return g;
    };
    const auto model = stagecraft::lagrangian<4, 2>(T, V, rods);
    return describe("double_pendulum", model, model, Eigen::Vector4d(1, 0, 2, 0), Eigen::Vector4d::Zero(), 2);
}

}  // namespace mechanics
