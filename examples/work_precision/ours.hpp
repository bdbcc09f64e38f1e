// SPDX-License-Identifier: BSL-1.0
// stagecraft's own entrants: Radau IIA with order control, and with a fixed number of stages.
#pragma once

#include <stagecraft/integrate.hpp>
#include <stagecraft/linear/banded_blocks.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>
#include <stagecraft/radau_iia_variable.hpp>
#include <vector>

#include "measure.hpp"

template <class Result>
outcome outcome_of(const Result& r) {
    return {.y = r.y,
            .ok = r.ok(),
            .steps = r.report.steps + r.report.rejected(),
            .f = r.report.f,
            .jacobians = r.report.jacobians,
            .factorisations = r.report.factorisations,
            .rejected = r.report.rejected(),
            .status = std::string(name(r.status))};
}

template <class Method, class Problem>
outcome run_ours(const Method& method, const Problem& problem, double tol, double t1) {
    stagecraft::options<double> options;
    options.rtol = tol;
    options.atol = tol * Problem::atol_scale;
    options.max_steps = 10'000'000;
    return outcome_of(stagecraft::integrate(method, problem, problem.initial(), Problem::t0, t1, options));
}

template <class Problem>
std::vector<entrant> our_entrants(const Problem& problem) {
    using stagecraft::radau_iia;
    return {
        {"stagecraft",
         [=](double tol, double t1) { return run_ours(stagecraft::radau_iia_variable(), problem, tol, t1); }},
        {"stagecraft s=3", [=](double tol, double t1) { return run_ours(radau_iia<3>(), problem, tol, t1); }},
        {"stagecraft s=5",
         [=](double tol, double t1) { return run_ours(radau_iia<5>(), problem, tol, t1); }}};
}
