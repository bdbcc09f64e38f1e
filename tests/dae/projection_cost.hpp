// SPDX-License-Identifier: BSL-1.0
// What a projection allocates in every step; in a program of its own (allocations.hpp).
#pragma once

#include <boost/test/unit_test.hpp>
#include <stagecraft/coefficients/gauss.hpp>
#include <stagecraft/coefficients/radau_iia.hpp>
#include <stagecraft/dae/projection.hpp>
#include <stagecraft/integrate.hpp>
#include <stagecraft/problem/semi_explicit.hpp>
#include <stdexcept>

#include "../allocations.hpp"
#include "problems.hpp"

namespace sc = stagecraft;

namespace {

// What is known of the derivatives of a problem with a state of run-time size.
enum class derivatives { automatic, own, differences };

// Allocations of each of 36 more steps: of a run of 40 less those of a run of 4.
template <class Run>
double allocations_per_step(const Run& run) {
    const auto made = [&](int steps) {
        const long before = allocations;
        run(steps);
        return allocations - before;
    };
    made(4);  // what is remembered of the method
    const long few = made(4);
    return static_cast<double>(made(40) - few) / 36;
}

// The same of runs of equal steps to t = 0.4, each corrected.
template <class Method, class Problem, class Vector>
double allocations_per_step(const Method& method, Problem& p, const Vector& y0,
                            const sc::projection_options& o) {
    return allocations_per_step([&](int steps) {
        auto keep = sc::projection(p, o);
        const auto r = sc::integrate(method, p, y0, 0, 0.4, {.fixed_step = 0.4 / steps}, keep);
        if (!r.ok() || r.report.steps != steps || keep.corrections() != steps)
            throw std::runtime_error("not every step was corrected");
    });
}

}  // namespace
