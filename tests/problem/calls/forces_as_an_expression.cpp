// SPDX-License-Identifier: BSL-1.0
// says: lagrangian: the constraint or Q returns an expression of Eigen's, whose operands may be gone before it is evaluated: write `return (-C * v).eval();`
// lines: 8
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) { return 0.5 * v.squaredNorm(); };
const auto potential = [](const auto& q) { return 9.81 * q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };
const auto damping = [](const auto&, const auto& v, const auto&) {
    const Eigen::Matrix2d C{{0.5, 0.1}, {0.1, 0.7}};
#ifdef RIGHT
    return (-(C * v)).eval();
#else
    return -(C * v);
#endif
};

auto model = stagecraft::lagrangian<2, 1>(kinetic, potential, length, damping);
