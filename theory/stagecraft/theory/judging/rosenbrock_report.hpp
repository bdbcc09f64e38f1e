// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <stagecraft/tableaux/partitioned_file.hpp>
#include <stagecraft/theory/judging/stability_report.hpp>
#include <vector>

namespace stagecraft::theory {

/// What `stability` says of a Rosenbrock or W method: its stability function is that of the diagonally implicit tableau of
/// beta = alpha + Gamma and b (Hairer-Wanner II.IV.7). Exact where the data are, of rounded data for each method within the rounding;
/// the theorems on Runge-Kutta methods for differential-algebraic problems say nothing of it. Throws std::invalid_argument for other
/// methods.
std::vector<report_section> stability_report(const tableaux::partitioned_file& file);

}  // namespace stagecraft::theory

#ifndef STAGECRAFT_COMPILED
#include "stagecraft/theory/judging/rosenbrock_report-inl.hpp"
#endif
