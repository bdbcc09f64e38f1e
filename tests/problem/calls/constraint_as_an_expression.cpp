// SPDX-License-Identifier: BSL-1.0
// says: lagrangian: the constraint or Q returns an expression of Eigen's, whose operands may be gone before it is evaluated: write `return (-C * v).eval();`
// lines: 8
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return 9.81 * q[1]; };
const auto rolling = [](const auto& q) {
#ifdef RIGHT
    return (0 * q + Eigen::Vector2d(1, -0.5)).transpose().eval();
#else
    return (0 * q + Eigen::Vector2d(1, -0.5)).transpose();
#endif
};

auto model = stagecraft::lagrangian<2, 1>(kinetic, potential, rolling);
