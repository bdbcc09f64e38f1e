// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <stagecraft/report.hpp>
#include <stagecraft/tableaux/nodal.hpp>
#include <utility>
#include <vector>

#include "any_problem.hpp"

namespace thesis {

using stagecraft::tableaux::family;
template <class Scalar>
using vector_of = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
using vector = vector_of<double>;

/// A problem ready to run: its initial state, and how to read lambda out of a state (which begins with q,
/// q').
template <class Scalar>
struct setup_of {
    problem_of<Scalar> problem;
    vector_of<Scalar> y0;
    std::function<Eigen::Matrix<Scalar, 2, 1>(const vector_of<Scalar>&)> multiplier;
};
using setup = setup_of<double>;

/// The four ways to write the regularised disc (mechanics/regularisation/regularised.hpp).
enum class form { mass_matrix, multiplier, creep, transformed };
const char* name(form f);

/// The rolling disc as index-2 system, index-reduced, and regularised (c = d = 2 as in the thesis), with
/// `offset` added to the consistent lambda(0). `transformed` is principal damping, whatever kappa says.
/// Scalar is double or long double. The spring and the damper are c and d.
template <class Scalar = double>
setup_of<Scalar> disc_dae();
setup disc_reduced();
template <class Scalar = double>
setup_of<Scalar> disc_regularised(form f, Scalar eps, Scalar kappa,
                                  const Eigen::Matrix<Scalar, 2, 1>& offset = {0, 0}, Scalar c = 2,
                                  Scalar d = 2);

/// The error of the regularised disc with kappa < 1 over eps, as eps -> 0: what the expansion (3.50), (3.51)
/// begins with.
struct correction {
    double t;
    vector Y;  ///< of q, q'
    Eigen::Vector2d Lambda;
};
std::vector<correction> disc_correction(double c, const std::vector<double>& times);

/// Total and kinetic energy and constraint G(q) q' of the disc in a state that begins with (q, q').
double disc_energy(const vector& y);
double disc_kinetic_energy(const vector& y);
template <class Scalar = double>
Eigen::Matrix<Scalar, 2, 1> disc_constraint(const vector_of<Scalar>& y);

/// The stage polynomial of a step that began at start.
struct piece {
    double start;
    std::function<vector(double)> at;
    double t0() const { return start; }
    vector operator()(double t) const { return at(t); }
};

/// How to run: adaptive with rtol = atol = tolerance, or with `steps` > 0 equal steps.
struct request {
    stagecraft::tableaux::family method = family::radau_iia;
    int stages = 3;
    std::vector<stagecraft::tableaux::rational> nodes{};  ///< collocation on these instead of a family's
    double tolerance = 1e-10;
    long steps = 0;
    double end = 1;
    /// An observer that may stop the run, e.g. std::ref of a singularity_watch; double only.
    std::function<bool(double t, const vector& y, double h, const piece&)> watch{};
};

/// One accepted step.
template <class Scalar>
struct point_of {
    Scalar t, h;
    vector_of<Scalar> y;
};

/// A run from t = 0; `path` holds every accepted step, the initial state first.
template <class Scalar>
struct trajectory_of {
    std::vector<point_of<Scalar>> path;
    stagecraft::report<Scalar> report;
    double microseconds = 0;  ///< processor time of this run, recording included
};
using trajectory = trajectory_of<double>;

/// Runs it; throws std::runtime_error with the status if the run neither reaches the end nor is stopped by
/// its watch.
template <class Scalar>
trajectory_of<Scalar> solve(const setup_of<Scalar>& s, const request& how);

/// The setup started from its own solution at time t; the problem must be autonomous.
setup restarted(setup s, double t);

/// Slope of the least-squares line through (log x, log y).
double slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace thesis
