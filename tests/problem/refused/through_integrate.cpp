// SPDX-License-Identifier: BSL-1.0
// says: problem.mass must be a member function
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

// A mass matrix that a const problem cannot be asked for: left out of account, y2 would grow as e^t.
struct problem {
    void operator()(double, const Eigen::Vector2d& y, Eigen::Vector2d& f) const { f << -y[0], y[1] - y[0]; }
#ifdef RIGHT
    Eigen::Matrix2d mass() const { return Eigen::Vector2d(1, 0).asDiagonal(); }
#else
    Eigen::Matrix2d mass() { return Eigen::Vector2d(1, 0).asDiagonal(); }
#endif
};

auto run(const problem& p) {
    return stagecraft::integrate(stagecraft::radau_iia<2>(), p, Eigen::Vector2d(1, 1), 0, 1);
}
