// SPDX-License-Identifier: BSL-1.0
// says: and return that type
// lines: 8
#include <array>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/states.hpp>
#include <vector>

const std::vector<double> start{1, 1};

#ifdef RIGHT
const auto problem = [](double, const auto& y) { return std::vector{y[1], -y[0]}; };
#else
const auto problem = [](double, const auto& y) { return std::array{y[1], -y[0]}; };
#endif

auto run() { return stagecraft::integrate(stagecraft::radau_iia<2>(), problem, start, 0, 1); }
