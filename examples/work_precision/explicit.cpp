// SPDX-License-Identifier: BSL-1.0
// Explicit methods: ours beside the Fortran codes and Boost.odeint with the same coefficients.
#include <stagecraft/tableaux/read.hpp>
#include <stagecraft/tableaux/tableau_from_file.hpp>

#include "compete.hpp"
#include "dopri.hpp"
#include "nonstiff.hpp"

namespace {

/// A method of the catalogue with its number of stages known at compile time.
template <int Stages>
stagecraft::tableau<double, Stages> from_catalogue(const std::string& name) {
    using namespace stagecraft::tableaux;
    const auto m = rounded<double>(read_tableau_file(CATALOGUE_DIR "/" + name + ".json"));
    return {m.A, m.b, m.c, m.b_embedded, m.facts};
}

template <class Problem>
void compete_explicitly(const settings& set, std::vector<curve>& curves) {
    if (!wanted(set.problems, Problem::name)) return;
    static const auto five = from_catalogue<7>("dormand_prince_5_4");
    static const auto eight = from_catalogue<12>("dormand_prince_8_5_3");
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

}  // namespace

bool open_dopri5(const std::string& library) {
    peers::dopri5 = peers::open_dopri(library, "dopri5_");
    return peers::dopri5 != nullptr;
}
bool open_dop853(const std::string& library) {
    peers::dop853 = peers::open_dopri(library, "dop853_");
    return peers::dop853 != nullptr;
}

void compete_on_nonstiff(const settings& set, std::vector<curve>& curves) {
    compete_explicitly<problems::arenstorf>(set, curves);
    compete_explicitly<problems::lorenz>(set, curves);
    compete_explicitly<problems::pleiades>(set, curves);
}
