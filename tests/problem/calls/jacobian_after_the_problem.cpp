// SPDX-License-Identifier: BSL-1.0
// says: a Jacobian goes with the problem: with_jacobian(f, J)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/with.hpp>

using Eigen::Vector2d;

const auto f = [](double, const Vector2d& y, Vector2d& out) { out = -y; };
const auto J = [](double, const Vector2d&, Eigen::Matrix2d& out) { out = -Eigen::Matrix2d::Identity(); };

#ifdef RIGHT
auto run() {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), stagecraft::with_jacobian(f, J), Vector2d(1, 1),
                                 0, 1);
}
#else
auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), f, J, Vector2d(1, 1), 0, 1); }
#endif
