// SPDX-License-Identifier: BSL-1.0
// says: take one component of that, p[0], say
// lines: 37
// lines of g++: 16
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const Vector2d p(1, 2);

const auto problem = [](const auto&, const auto& y, auto& f) {
#ifdef RIGHT
    f[0] = -p[0] * y[0] + p.dot(y) + p.transpose() * y;
#else
    f[0] = -p * y[0];
#endif
    f[1] = y[1];
};

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1); }
