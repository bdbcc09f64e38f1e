// SPDX-License-Identifier: BSL-1.0
// says: tell must be callable as tell(part)
// lines: 8
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/observe/progress.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    const auto tell = [](double t, double part) { return t + part < 2; };
    return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1, {},
                                 stagecraft::progress(tell));
}
