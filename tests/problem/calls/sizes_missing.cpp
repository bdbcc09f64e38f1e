// SPDX-License-Identifier: BSL-1.0
// says: semi_explicit<n, m>(f, g): give n, the number of components of y, and m
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>

using Eigen::Vector2d, Eigen::Vector;

const auto f = [](const auto&, const auto& y, const auto& z, auto& out) { out[0] = z[0] - y[0]; };
const auto g = [](const auto&, const auto& y, const auto& z, auto& out) { out[0] = z[0] + y[0]; };

auto run() {
#ifdef RIGHT
    const auto problem = stagecraft::semi_explicit<1, 1>(f, g);
#else
    const auto problem = stagecraft::semi_explicit(f, g);
#endif
    const auto y0 = problem.state<double>(Vector<double, 1>(1), Vector<double, 1>(-1));
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, y0, 0, 1);
}

#ifdef RIGHT
auto sized(const Vector2d& y, long m) { return stagecraft::semi_explicit(f, g, y.size(), m); }
#endif
