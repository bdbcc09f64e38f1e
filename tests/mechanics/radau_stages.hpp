// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cmath>
#include <problems/thesis/solve.hpp>

namespace thesis {

inline const std::array<double, 3> radau_nodes{(4 - std::sqrt(6.0)) / 10, (4 + std::sqrt(6.0)) / 10, 1};

/// The stages (Y_ni, Lambda_ni) of one step of Radau IIA-3: its collocation polynomial at the nodes.
inline std::array<vector, 3> stages(const setup& s, double step) {
    std::array<vector, 3> values;
    request one{.tolerance = 1e-12, .steps = 1, .end = step};
    one.watch = [&](double, const vector&, double, const piece& p) {
        for (int i = 0; i < 3; ++i) values[i] = p(radau_nodes[i] * step);
        return true;
    };
    solve(s, one);
    return values;
}

}  // namespace thesis
