// SPDX-License-Identifier: BSL-1.0
// says: write the sum of the parts of split(f_explicit, f_implicit)
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/problem/split.hpp>
#include <stagecraft/sensitivity/forward.hpp>

using Eigen::Vector2d;

auto run() {
    const auto f = [](const auto&, const auto& y, const auto& p, auto& f) { f = -p[0] * y; };
    return stagecraft::sensitivities(stagecraft::radau_iia<2>(), stagecraft::split(f, f), Vector2d(1, 1),
                                     Vector2d(1, 1), 0, 1);
}
