// SPDX-License-Identifier: BSL-1.0
// says: steps: the problem must be callable as problem(t, y, f)
// lines: 8
#include <array>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/steps.hpp>

using Eigen::Vector2d;

const auto problem = [](double, const Vector2d& y) { return std::array{y[1], -y[0]}; };

double run() {
    double sum = 0;
    for (const auto& step : stagecraft::steps(stagecraft::radau_iia<2>(), problem, Vector2d(1, 1), 0, 1))
        sum += step.y[0];
    return sum;
}
