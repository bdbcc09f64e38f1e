// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include "measure.hpp"

/// The table: problem, solver, tolerance, error, minimum and median time, steps, f, Jacobians,
/// factorisations.
void print_table(const std::vector<curve>& curves);
/// The same as comma-separated values.
void write_csv(const std::vector<curve>& curves, const std::string& file);
/// One log-log diagram per problem, all solvers in one picture, drawn with gnuplot. Throws std::runtime_error
/// where gnuplot is missing.
void write_diagrams(const std::vector<curve>& curves, const std::string& directory);
/// One line per peer: geometric mean time ratio at equal error, over all problems and the named subsets.
void print_ratios(const std::vector<curve>& curves, const std::string& ours);
/// Of the implicit-explicit tables: ours beside ARKODE's of the same order, problem by problem.
void print_same_tables(const std::vector<curve>& curves);
