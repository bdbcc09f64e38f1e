// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "brusselator_2d.hpp"

// What is measured of every solver: the error at t1, and how often the preconditioner was applied (cycles) and set up.

struct outcome {
    bool reached = false;
    Eigen::VectorXd y;
    long steps = 0, cycles = 0, setups = 0;
    /// In cycles: a setup costs about five.
    double cost() const { return static_cast<double>(cycles) + 5 * static_cast<double>(setups); }
};

/// Root mean square of the errors relative to 1 + |y|, over all processes.
inline double error_of(const brusselator_2d& problem, const Eigen::VectorXd& y,
                       const Eigen::VectorXd& reference) {
    double sum[2] = {((y - reference).array() / (1 + reference.array().abs())).square().sum(),
                     static_cast<double>(y.size())};
    problem.add_up(sum, 2);
    return std::sqrt(sum[0] / sum[1]);
}

struct point {
    double tolerance, error, cost, cycles;
};
struct curve {
    std::string solver;
    std::vector<point> points;  ///< by falling tolerance

    /// A quantity of the points at a given error, interpolated in log-log between neighbouring tolerances; nothing
    /// outside of the errors that were met.
    std::optional<double> at(double error, double point::*quantity) const {
        for (std::size_t k = 1; k < points.size(); ++k) {
            const point &a = points[k - 1], &b = points[k];
            if (!(a.error >= error && b.error <= error) || a.error == b.error) continue;
            const double part = std::log(a.error / error) / std::log(a.error / b.error);
            return std::exp((1 - part) * std::log(a.*quantity) + part * std::log(b.*quantity));
        }
        return std::nullopt;
    }
};

#ifdef HAVE_SUNDIALS
/// CVODE's BDF with its own GMRES, from the right.
outcome run_cvode(double tolerance, double t1, int grid);
#endif
/// A stepper of PETSc's own (TSSetType) with Newton's iteration and flexible GMRES.
outcome run_petsc(const char* type, double tolerance, double t1, int grid);

/// Prints the table of iterations, then cost against error for every solver, with ratios as last lines.
void print_report(double t1, int grid);
