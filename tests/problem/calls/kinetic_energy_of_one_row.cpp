// SPDX-License-Identifier: BSL-1.0
// says: lagrangian: T and V must return a number, not a matrix or product of Eigen's: write 0.5 * v.dot(M * v), or (0.5 * v.transpose() * M * v).value()
// lines: 8
#include <stagecraft/integrate.hpp>
#include <stagecraft/mechanics/lagrangian.hpp>

const auto kinetic = [](const auto&, const auto& v) {
    const Eigen::Matrix2d M{{2, 1}, {1, 3}};
#ifdef RIGHT
    return (0.5 * v.transpose() * M * v).value();
#else
    return 0.5 * v.transpose() * M * v;
#endif
};
const auto potential = [](const auto& q) { return q[1]; };
const auto length = [](const auto& q) { return q.squaredNorm() - 1; };

auto model = stagecraft::lagrangian<2, 1>(kinetic, potential, length);
