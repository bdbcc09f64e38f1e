// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/family.hpp>
#include <vector>

namespace thesis {

/// Largest errors of the rolling disc over every step of [0, 1/5].
struct wide_error {
    double y, lambda;
};

/// The index-2 system with equal steps at 50 digits, where rounding hides no order: one error for each number
/// of steps, all of which must divide 48. Measured against Radau IIA with 12 stages.
std::vector<wide_error> errors_at_50_digits(stagecraft::tableaux::family f, int stages,
                                            const std::vector<int>& steps);

}  // namespace thesis
