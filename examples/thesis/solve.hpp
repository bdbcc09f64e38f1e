// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <stagecraft/report.hpp>
#include <stagecraft/tableaux/family.hpp>
#include <vector>

#include "any_problem.hpp"

namespace thesis {

using stagecraft::tableaux::family;
using vector = Eigen::VectorXd;

/// A problem ready to run: its initial state, and how to read lambda out of a state (which begins with q,
/// q').
struct setup {
    any_problem problem;
    vector y0;
    std::function<Eigen::Vector2d(const vector&)> multiplier;
};

/// The four ways to write the regularised disc (problem/regularised.hpp).
enum class form { mass_matrix, multiplier, creep, transformed };
const char* name(form f);

/// The rolling disc as index-2 system, index-reduced, and regularised (c = d = 2 as in the thesis), with
/// `offset` added to the consistent lambda(0). `transformed` is principal damping, whatever kappa says.
setup disc_dae();
setup disc_reduced();
setup disc_regularised(form f, double eps, double kappa, const Eigen::Vector2d& offset = {0, 0});

/// Total and kinetic energy and constraint G(q) q' of the disc in a state that begins with (q, q').
double disc_energy(const vector& y);
double disc_kinetic_energy(const vector& y);
Eigen::Vector2d disc_constraint(const vector& y);

/// How to run: adaptive with rtol = atol = tolerance, or with `steps` > 0 equal steps.
struct request {
    stagecraft::tableaux::family method = family::radau_iia;
    int stages = 3;
    double tolerance = 1e-10;
    long steps = 0;
    double end = 1;
};

/// One accepted step.
struct point {
    double t, h;
    vector y;
};

/// A run from t = 0; `path` holds every accepted step, the initial state first.
struct trajectory {
    std::vector<point> path;
    stagecraft::report<double> report;
    double microseconds = 0;  ///< of this run, recording included
};

/// Runs it; throws std::runtime_error with the status if the run does not reach the end.
trajectory solve(const setup& s, const request& how);

/// Slope of the least-squares line through (log x, log y).
double slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace thesis
