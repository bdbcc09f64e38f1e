// SPDX-License-Identifier: BSL-1.0
// incompressible_flow [-n N] [-stages S] [-t1 T1] [any PETSc option], alone or under mpirun: Radau IIA with S stages in
// 8, 16, 32 steps, the errors of velocity and pressure, and the orders that they show.
#include <cmath>
#include <cstdio>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>

#include "incompressible_flow.hpp"

namespace sc = stagecraft;

int main(int count, char** arguments) {
    if (PetscInitialize(&count, &arguments, nullptr, nullptr) != 0) return 1;
    PetscInt n = 16, s = 3;
    PetscReal t1 = 0.4, tol = 1e-10;
    PetscOptionsGetInt(nullptr, nullptr, "-n", &n, nullptr);
    PetscOptionsGetInt(nullptr, nullptr, "-stages", &s, nullptr);
    PetscOptionsGetReal(nullptr, nullptr, "-t1", &t1, nullptr);
    PetscOptionsGetReal(nullptr, nullptr, "-tol", &tol, nullptr);
    split_fields();
    std::array<double, 2> before{NAN, NAN};
    PetscPrintf(PETSC_COMM_WORLD, "%6s%11s%8s%11s%8s%9s%8s%7s%7s\n", "steps", "velocity", "order", "pressure",
                "order", "Newton", "cycles", "real", "pair");
    for (const int steps : {8, 16, 32}) {
        const counted_flow problem(n);
        const auto r = sc::integrate(sc::radau_iia(static_cast<int>(s)), problem, problem.solution(0), 0.0,
                                     t1, {.rtol = tol, .atol = tol, .fixed_step = t1 / steps});
        const auto e = problem.errors(r.t, r.y);
        const auto& c = problem.J.counts();
        PetscPrintf(PETSC_COMM_WORLD, "%6ld%11.2e%8.2f%11.2e%8.2f%9ld%8ld%7.2f%7.2f%s\n", r.report.steps,
                    e[0], std::log2(before[0] / e[0]), e[1], std::log2(before[1] / e[1]), r.report.solves,
                    c.cycles, double(c.real_iterations) / double(c.real_solves),
                    double(c.pair_iterations) / double(c.pair_solves), r.ok() ? "" : name(r.status));
        before = e;
    }
    return PetscFinalize();
}
