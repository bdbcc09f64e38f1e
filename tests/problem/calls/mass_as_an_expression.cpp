// SPDX-License-Identifier: BSL-1.0
// says: returns the n x n matrix M (an object, not an expression: write its type or .eval())
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

struct problem {
    void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const { f << -y[0], y[1] - y[0]; }
#ifdef RIGHT
    Eigen::Matrix2d mass() const { return Eigen::Vector2d(1, 0).asDiagonal(); }
#else
    auto mass() const { return Eigen::Vector2d(1, 0).asDiagonal(); }
#endif
};

auto run() {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem{}, Eigen::Vector2d(1, 1), 0, 1);
}
