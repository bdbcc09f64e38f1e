// SPDX-License-Identifier: BSL-1.0
// says: (or a vector of Eigen's, not an expression: write its type or .eval())
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

struct problem {
    void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const { f << -y[1], y[0]; }
    Eigen::Matrix2d mass() const { return Eigen::Vector2d(1, 0).asDiagonal(); }
    auto index() const {
        const Eigen::Vector2i differentiations(0, 1);
#ifdef RIGHT
        return (differentiations + Eigen::Vector2i(1, 1)).eval();
#else
        return differentiations + Eigen::Vector2i(1, 1);
#endif
    }
};

auto run() {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem{}, Eigen::Vector2d(1, 1), 0, 1);
}
