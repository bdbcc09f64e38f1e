// SPDX-License-Identifier: BSL-1.0
// says: integrate: the problem returns an expression of Eigen's, whose operands may be gone before it is evaluated: write `-> Eigen::Vector2d`, the type of y0, or `return (A * y).eval();`
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Matrix2d, Eigen::Vector2d;

#ifdef RIGHT
const auto problem = [](double, const Vector2d& y) -> Vector2d {
#else
const auto problem = [](double, const Vector2d& y) {
#endif
    const Matrix2d A{{-1, 2}, {-2, -1}};
    return A * y;
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<3>(), problem, Vector2d(1, 0), 0, 1); }
