// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <work_precision/measure.hpp>

/// A row for each tolerance, 1e-3 ... 1e-12: `run` returns the numbers that `exact` has, and whether it ended well.
void print(const char* kind, const char* problem, const char* method, int unknowns,
           const Eigen::VectorXd& exact, const std::function<outcome(double)>& run);

// The kinds, in a file each as they compile for long.
void initial_values();
void differential_algebraic();
void mechanics();
void boundary_values();
