// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/integrate.hpp>

#include "kinds.hpp"

/// A run of `integrate`, of which the first components are compared.
template <class Method, class Problem, class State>
void print_run(const char* kind, const char* problem, const char* name, const Method& method,
               const Problem& p, const State& y0, double t1, const Eigen::VectorXd& exact) {
    print(kind, problem, name, static_cast<int>(y0.size()), exact, [&](double tol) {
        const auto r = stagecraft::integrate(method, p, y0, 0, t1, {.rtol = tol, .atol = tol});
        return outcome{.y = r.y.head(exact.size()), .ok = r.ok()};
    });
}
