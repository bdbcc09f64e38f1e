// SPDX-License-Identifier: BSL-1.0
// Explicit methods: ours beside the Fortran codes and Boost.odeint with the same coefficients.
#pragma once

#include <stagecraft/coefficients/explicit.hpp>

#include "compete.hpp"
#include "dopri.hpp"
#include "nonstiff.hpp"

/// One problem a file: g++ inlines less where a file holds many integrators, as no program of one problem does.
template <class Problem>
void compete_explicitly(const settings& set, std::vector<curve>& curves) {
    if (!wanted(set.problems, Problem::name)) return;
    const auto five = stagecraft::dormand_prince_5_4();
    const auto eight = stagecraft::dormand_prince_8_5_3();
    const Problem problem;
    std::vector<entrant> all = {
        {"stagecraft 5(4)", [=](double tol, double t1) { return run_ours(five, problem, tol, t1); }},
        {"stagecraft 8(5,3)", [=](double tol, double t1) { return run_ours(eight, problem, tol, t1); }},
        {"odeint", [=](double tol, double t1) { return peers::odeint_dopri5(problem, tol, t1); }}};
    for (const auto& [name, solver] :
         {std::pair{"dopri5", peers::dopri5}, std::pair{"dop853", peers::dop853}})
        if (solver)
            all.push_back({name, [=, solver = solver](double tol, double t1) {
                               return peers::dopri(solver, problem, tol, t1);
                           }});
    std::erase_if(all, [&](const entrant& e) { return !wanted(set.solvers, e.solver); });
    const Eigen::VectorXd end = reference(Problem::name);
    const auto error = [&](const Eigen::VectorXd& y) { return scaled_error(y, end, Problem::atol_scale); };
    const std::size_t first = curves.size();
    for (const entrant& e : all) curves.push_back({Problem::name, e.solver, Problem::size, false, false, {}});
    for (const double tol : set.tolerances) {
        const auto points = measure(all, tol, Problem::t1, set.repeats, set.patience, error);
        for (std::size_t e = 0; e < all.size(); ++e) curves[first + e].points.push_back(points[e]);
    }
}
