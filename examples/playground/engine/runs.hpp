// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <stagecraft/options.hpp>
#include <stagecraft/tableau.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "problems.hpp"

// Runs of the library's steppers, compiled once for all methods and problems of the page.
namespace playground {

/// With an error estimate of the family, or a tableau, whose embedded weights estimate.
using runnable = std::variant<stagecraft::transformed_tableau<double>, stagecraft::tableau<double>>;

/// The run as the page draws it: {"status", "t", "points": [[t, y...]], "steps": [[t, h, refused for the error, refused by
/// Newton]], "report"}. The points are those of the continuous solution, the ends of steps among them, and at most 4000 of them. Throws
/// std::invalid_argument as integrate() does.
nlohmann::ordered_json run(const runnable& method, const problem& p, double t1,
                           const stagecraft::options<double>& o);

/// The errors at t1 of n equal steps: {"h", "f", "status", "errors": {"1": of the components of index 1, ...}}, each the
/// largest of its components. The solution is p.solution, or else that of accurate().
nlohmann::ordered_json error_at_end(const runnable& method, const problem& p, double t1, int n,
                                    const Eigen::VectorXd& solution);

/// The solution at t1 from Radau IIA of five stages and tolerances of 1e-13. Throws std::runtime_error where the run ends before.
Eigen::VectorXd accurate(const problem& p, double t1);

/// For `count` step sizes from `low` to `high`: [h, x, ...], where runs of y' = y (1 - y) from four starts are after 300
/// steps and the 40 that follow; of those that do not go to infinity.
nlohmann::ordered_json orbits(const runnable& method, const problem& p, double low, double high, int count);

}  // namespace playground
