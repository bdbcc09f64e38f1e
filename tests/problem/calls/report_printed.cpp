// SPDX-License-Identifier: BSL-1.0
// says: write print(std::cout, r.report) of stagecraft/report_text.hpp
// lines: 8
#include <iostream>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/integrate.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y, Vector2d& f) { f = -y; };

auto run() {
    std::cout << stagecraft::integrate(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1).report;
}
