// SPDX-License-Identifier: BSL-1.0
// All solvers on one problem.
#pragma once

#include <algorithm>
#include <iostream>
#include <problems/stored.hpp>
#include <string>
#include <vector>

#include "measure.hpp"
#include "odeint.hpp"
#include "ours.hpp"
#include "radau5.hpp"
#ifdef HAVE_SUNDIALS
#include "sundials_arkode.hpp"
#include "sundials_ida.hpp"
#endif

struct settings {
    std::vector<std::string> problems, solvers;
    std::vector<double> tolerances;
    int repeats = 5;
    double patience = 1.0;  // seconds per solver and tolerance after which two repeats suffice
};

using problems::reference;

inline bool wanted(const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

template <class Problem>
outcome run_rosenbrock4(const Problem& problem, double tol, double t1) {
    using state = state_of<Problem>;
    outcome out;
    const state y0 = problem.initial();
    std::vector<double> y(y0.begin(), y0.end());
    const auto f = [&](double t, const double* x, double* to) {
        state in = Eigen::Map<const state>(x), value;
        problem(t, in, value);
        std::copy(value.begin(), value.end(), to);
        ++out.f;
    };
    const auto jacobian = [&](double t, const double* x, double* to) {
        state in = Eigen::Map<const state>(x);
        jacobian_of<Problem> J;
        problem.jacobian(t, in, J);
        Eigen::Map<Eigen::Matrix<double, Problem::size, Problem::size, Eigen::RowMajor>>{to} = J;
        ++out.jacobians;
    };
    out.ok = peers::rosenbrock4(y, Problem::t0, t1, tol, tol * Problem::atol_scale, f, jacobian, out.steps);
    out.factorisations = out.jacobians;
    out.y = Eigen::Map<const Eigen::VectorXd>(y.data(), y0.size());
    return out;
}

template <class Problem>
std::vector<entrant> entrants(const Problem& problem) {
    std::vector<entrant> all = our_entrants(problem);
    const auto add = [&](std::string name, auto run) { all.push_back({std::move(name), run}); };
    constexpr bool sparse = requires { problem.sparsity(); };  // the peers run the same problem banded
    constexpr bool has_mass = requires { problem.mass(); };
    constexpr bool small = Problem::size != Eigen::Dynamic && Problem::size <= 15;
    if constexpr (!sparse) {
        if (peers::radau5_available())
            add("radau5", [&](double tol, double t1) {
                return peers::radau(peers::radau5_symbol(), problem, tol, t1);
            });
        if (peers::radau_symbol != nullptr)
            add("radau",
                [&](double tol, double t1) { return peers::radau(peers::radau_symbol, problem, tol, t1); });
#ifdef HAVE_SUNDIALS
        if constexpr (has_mass)
            add("ida", [&](double tol, double t1) { return peers::sundials::ida(problem, tol, t1); });
        if constexpr (!has_mass) {
            add("cvode", [&](double tol, double t1) { return peers::sundials::cvode(problem, tol, t1); });
            add("arkode", [&](double tol, double t1) { return peers::sundials::arkode(problem, tol, t1); });
        }
#endif
        if constexpr (!has_mass && small)
            add("rosenbrock4", [&](double tol, double t1) { return run_rosenbrock4(problem, tol, t1); });
    }
    return all;
}

/// The curves of all that are wanted on one problem, from 0 to t1, at the tolerances of at least `least`.
inline void measure_all(const curve& kind, std::vector<entrant> all, double t1, double least,
                        const std::function<double(const Eigen::VectorXd&)>& error, const settings& set,
                        std::vector<curve>& curves) {
    std::erase_if(all, [&](const entrant& e) { return !wanted(set.solvers, e.solver); });
    std::vector<curve> result(all.size(), kind);
    for (std::size_t e = 0; e < all.size(); ++e) result[e].solver = all[e].solver;
    for (const double tolerance : set.tolerances) {
        if (tolerance < least) continue;
        std::cerr << "\r" << kind.problem << "  tol " << tolerance << "        " << std::flush;
        const auto points = measure(all, tolerance, t1, set.repeats, set.patience, error);
        for (std::size_t e = 0; e < all.size(); ++e) result[e].points.push_back(points[e]);
    }
    curves.insert(curves.end(), result.begin(), result.end());
}

/// Measures every wanted solver at every tolerance; `end` is the reference at t1, `inside` those known at
/// times between: the error there is that of runs which end there, not timed.
template <class Problem>
void compete(const Problem& problem, const Eigen::VectorXd& end, const settings& set,
             std::vector<curve>& curves, const std::vector<reference_point>& inside = {}) {
    if (!wanted(set.problems, Problem::name)) return;
    std::vector<entrant> all = entrants(problem);
    if constexpr (requires { problem.mass(); })
        std::cerr << "\r" << Problem::name
                  << ": cvode, arkode and rosenbrock4 are left out: they take no singular mass matrix\n";
    std::erase_if(all, [&](const entrant& e) { return !wanted(set.solvers, e.solver); });
    const auto error = [&](const Eigen::VectorXd& y) { return scaled_error(y, end, Problem::atol_scale); };
    std::vector<curve> result;
    for (const entrant& e : all)
        result.push_back({Problem::name,
                          e.solver,
                          static_cast<int>(end.size()),
                          requires { Problem::lower;
}
, !inside.empty(), {}
});
for (const double tol : set.tolerances) {
    std::cerr << "\r" << Problem::name << "  tol " << tol << "        " << std::flush;
    std::vector<point> points = measure(all, tol, Problem::t1, set.repeats, set.patience, error);
    for (std::size_t e = 0; e < all.size(); ++e) {
        points[e].largest_error = points[e].error;
        for (const reference_point& r : inside) {
            const outcome at = all[e].run(tol, r.t);
            const double there = at.ok ? scaled_error(at.y, r.y, Problem::atol_scale)
                                       : std::numeric_limits<double>::infinity();
            points[e].largest_error = std::max(points[e].largest_error, there);
        }
        result[e].points.push_back(points[e]);
    }
}
curves.insert(curves.end(), result.begin(), result.end());
}
