// SPDX-License-Identifier: BSL-1.0
#include <petscts.h>

#include <functional>
#include <initializer_list>
#include <limits>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <tuple>

#include "contest.hpp"

namespace sc = stagecraft;
using sc::petsc_check;

namespace {

template <class... Values>
void say(const char* format, Values... values) {
    petsc_check(PetscPrintf(PETSC_COMM_WORLD, format, values...));
}
void tolerance_of_solves(const char* value) {
    for (const char* which : {"-stage_real_ksp_rtol", "-stage_pair_ksp_rtol"})
        petsc_check(value ? PetscOptionsSetValue(nullptr, which, value)
                          : PetscOptionsClearValue(nullptr, which));
}

// How many iterations reduce the residual to a ten-thousandth: the most of all systems of a method, with J at the
// equilibrium of the reaction and the right-hand sides f(y0) and y0, the halves of that of a pair.
void print_iterations(std::initializer_list<int> sizes) {
    tolerance_of_solves("1e-4");
    say("iterations to 1e-4, real and pair, the most of all systems of a method\n");
    say("%6s%8s%9s%9s%9s%9s\n", "N", "h", "s = 3", "5", "7", "9");
    for (const int size : sizes) {
        const brusselator_2d problem(size);
        const int n = static_cast<int>(problem.start().size());
        Eigen::VectorXd x(2 * n);
        const auto choose = [&] {
            x.tail(n) = problem.start();
            problem.evaluate(x.data() + n, x.data());
        };
        for (const double h : {1e-3, 1e-2, 1e-1}) {
            say("%6d%8.0e", size, h);
            for (const int s : {3, 5, 7, 9}) {
                const auto method = sc::radau_iia(s);
                const auto J = problem.matrix();
                problem.fill(problem.equilibrium().data(), J.get());
                sc::petsc_blocks::real real(n);
                real.factor_shifted(sc::identity_mass(), J, method.gamma[0] / h);
                choose();
                real.solve(x.data());
                for (int k = 0; k < method.alpha.size(); ++k) {
                    sc::petsc_blocks::complex pair(n);
                    pair.factor_shifted(sc::identity_mass(), J, method.alpha[k] / h, -method.beta[k] / h);
                    choose();
                    pair.solve(x.data(), x.data() + n);
                }
                say("%5ld%4ld", J.counts().most_real, J.counts().most_pair);
            }
            say("\n");
        }
    }
    tolerance_of_solves(nullptr);
}

template <class Method>
outcome run_ours(const Method& method, double tolerance, double t1, int grid) {
    const counted_brusselator problem(grid);
    const auto r =
        sc::integrate(method, problem, problem.start(), 0.0, t1, {.rtol = tolerance, .atol = tolerance});
    return {r.ok(), r.y, r.report.steps, problem.J.counts().cycles, problem.J.counts().setups};
}

}  // namespace

void print_report(double t1, int grid) {
    print_iterations({64, 128, 256});

    const auto reference = run_ours(sc::radau_iia(9), 1e-12, t1, grid);
    const brusselator_2d problem(grid);
    struct entrant {
        const char* name;
        std::function<outcome(double)> run;
        double least;  // the smallest tolerance that it is asked for
    };
    const auto radau = [&](int s) {
        return [=](double tolerance) { return run_ours(sc::radau_iia(s), tolerance, t1, grid); };
    };
    const auto stepper = [&](const char* type) {
        return [=](double tolerance) { return run_petsc(type, tolerance, t1, grid); };
    };
    const sc::variable_order variable{
        std::make_tuple(sc::radau_iia(3), sc::radau_iia(5), sc::radau_iia(7), sc::radau_iia(9))};
    const std::vector<entrant> entrants{
        {"Radau IIA, variable", [&](double tolerance) { return run_ours(variable, tolerance, t1, grid); },
         1e-11},
        {"Radau IIA, s = 3", radau(3), 1e-8},
        {"Radau IIA, s = 5", radau(5), 1e-11},
        {"Radau IIA, s = 7", radau(7), 1e-11},
#ifdef HAVE_SUNDIALS
        {"CVODE", [=](double tolerance) { return run_cvode(tolerance, t1, grid); }, 1e-12},
#endif
        {"PETSc, TSBDF", stepper(TSBDF), 1e-7},
        {"PETSc, TSARKIMEX", stepper(TSARKIMEX), 1e-7},
        {"PETSc, TSROSW", stepper(TSROSW), 1e-6}};
    say("\ncost against error at t = %g, N = %d: cycles + 5 setups\n", t1, grid);
    say("%-22s%9s%11s%8s%9s%8s%9s\n", "", "tol", "error", "steps", "cycles", "setups", "cost");
    std::vector<curve> curves;
    for (const entrant& e : entrants) {
        curve c{e.name, {}};
        for (double tolerance = 1e-3; tolerance > 0.5 * e.least; tolerance /= 10) {
            const outcome r = e.run(tolerance);
            const double error = r.reached ? error_of(problem, r.y, reference.y) : NAN;
            say("%-22s%9.0e%11.2e%8ld%9ld%8ld%9.0f%s\n", e.name, tolerance, error, r.steps, r.cycles,
                r.setups, r.cost(), r.reached ? "" : "  did not reach the end");
            if (r.reached) c.points.push_back({tolerance, error, r.cost(), static_cast<double>(r.cycles)});
        }
        curves.push_back(c);
    }

    // The best of a group of solvers at an error.
    const auto best = [&](const char* prefix, double error, double point::*quantity) {
        double least = std::numeric_limits<double>::infinity();
        for (const curve& c : curves)
            if (c.solver.rfind(prefix, 0) == 0)
                if (const auto at = c.at(error, quantity)) least = std::min(least, *at);
        return least;
    };
    const auto ratio = [](double ours, double theirs) {
        return ours < std::numeric_limits<double>::infinity() &&
                       theirs < std::numeric_limits<double>::infinity()
                   ? ours / theirs
                   : std::numeric_limits<double>::quiet_NaN();
    };
    say("\nthe best Radau IIA of fixed order to others at equal error (nan: an error that one did not "
        "reach)\n");
    for (const double error : {1e-6, 1e-8, 1e-10}) {
        const double ours = best("Radau IIA, s", error, &point::cost);
        say("error %.0e: cost to CVODE %.2f (of variable order %.2f), ", error,
            ratio(ours, best("CVODE", error, &point::cost)),
            ratio(best("Radau IIA, v", error, &point::cost), best("CVODE", error, &point::cost)));
        say("to the best of PETSc's steppers: cost %.2f, cycles %.2f\n",
            ratio(ours, best("PETSc", error, &point::cost)),
            ratio(best("Radau IIA, s", error, &point::cycles), best("PETSc", error, &point::cycles)));
    }
}
