// SPDX-License-Identifier: BSL-1.0
// says: radau_iia(s) of stagecraft/families.hpp
// lines: 24
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run(int s) {
#ifdef RIGHT
    const auto method = stagecraft::radau_iia(s);
#else
    const auto method = stagecraft::radau_iia<s>();
#endif
    return stagecraft::integrate(method, problem, Vector2d(1, 1), 0, 1);
}
