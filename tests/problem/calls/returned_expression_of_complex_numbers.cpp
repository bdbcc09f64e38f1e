// SPDX-License-Identifier: BSL-1.0
// says: integrate: the problem returns an expression of Eigen's, whose operands may be gone before it is evaluated: write `-> Eigen::Vector2cd`
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/states.hpp>

using Eigen::Matrix2cd, Eigen::Vector2cd;

#ifdef RIGHT
const auto problem = [](double, const Vector2cd& y) -> Vector2cd {
#else
const auto problem = [](double, const Vector2cd& y) {
#endif
    const Matrix2cd A{{-1, 2}, {-2, -1}};
    return A * y;
};

auto run() {
    const Vector2cd start(1, 0);
    return stagecraft::integrate(stagecraft::radau_iia<3>(), problem, start, 0, 1);
}
