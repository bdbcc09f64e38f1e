// SPDX-License-Identifier: BSL-1.0
// Runs of a formulation, ours and RADAU5's.
#pragma once

#include <array>
#include <string>

#include "body.hpp"

namespace mechanics {

struct outcome {
    bool ok = false;
    std::string status;
    VectorXd y;
    long steps = 0, f = 0;
    double microseconds = 0;        ///< the least of the repetitions
    std::array<double, 3> drift{};  ///< largest |g|, |G v + b| and change of energy at the accepted steps
};

/// Radau IIA of variable order with rtol = atol = tolerance. The drift is looked at in a run of its own.
outcome run_ours(const body& b, const formulation& f, double tolerance, int repeats);

bool radau5_available();
/// RADAU5 (deSolve's) on the same f, Jacobian and index flags, with its option for rows q' = v where there are some.
outcome run_radau5(const body& b, const formulation& f, double tolerance, int repeats);

}  // namespace mechanics
