// SPDX-License-Identifier: BSL-1.0
// says: returns the index of every component, as a std::array<int, n>
// lines: 8
#include <array>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Matrix2d, Eigen::Vector2d;

struct problem {
    void operator()(double, const Vector2d& y, Vector2d& f) const { f = -y; }
    Matrix2d mass() const { return Matrix2d::Identity(); }
    std::array<double, 2> index() const { return {1, 1}; }
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem(), Vector2d(1, 1), 0, 1); }
