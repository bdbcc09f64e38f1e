// SPDX-License-Identifier: BSL-1.0
// brusselator_2d [-n N] [-stages S] [-tol T] [-t1 T1] [any PETSc option], alone or under mpirun: the Brusselator with
// diffusion on N x N points by Radau IIA with S stages, solved by PETSc. With --report instead: iterations against N, h
// and s, and cost against error beside CVODE and PETSc's own steppers, at N points.
#include <cstdio>
#include <stagecraft/families.hpp>
#include <stagecraft/integrate.hpp>
#include <string>

#include "contest.hpp"

namespace sc = stagecraft;

int main(int count, char** arguments) {
    bool report = false;
    for (int k = 1; k < count; ++k) report = report || std::string(arguments[k]) == "--report";
    if (PetscInitialize(&count, &arguments, nullptr, nullptr) != 0) return 1;
    PetscInt n = 64, s = 3;
    PetscReal tol = 1e-4, t1 = 1;
    PetscOptionsGetInt(nullptr, nullptr, "-n", &n, nullptr);
    PetscOptionsGetInt(nullptr, nullptr, "-stages", &s, nullptr);
    PetscOptionsGetReal(nullptr, nullptr, "-tol", &tol, nullptr);
    PetscOptionsGetReal(nullptr, nullptr, "-t1", &t1, nullptr);
    if (report) {
        print_report(t1, static_cast<int>(n));
    } else {
        const counted_brusselator problem(n);
        const double begin = MPI_Wtime();
        const auto r = sc::integrate(sc::radau_iia(static_cast<int>(s)), problem, problem.start(), 0.0, t1,
                                     {.rtol = tol, .atol = tol});
        const auto& c = problem.J.counts();
        double sum[2] = {r.y.squaredNorm(), static_cast<double>(r.y.size())};
        problem.add_up(sum, 2);
        PetscPrintf(PETSC_COMM_WORLD,
                    "%s, %.0f unknowns: %ld steps, %ld rejected, %ld Newton iterations, %ld Jacobians, %ld "
                    "factorisations\n",
                    name(r.status), sum[1], r.report.steps, r.report.rejected(), r.report.solves,
                    r.report.jacobians, r.report.factorisations);
        PetscPrintf(PETSC_COMM_WORLD,
                    "%ld cycles, %ld setups; %.2f real and %.2f pair iterations a solve; rms %.15g; %.1f s\n",
                    c.cycles, c.setups, double(c.real_iterations) / double(c.real_solves),
                    double(c.pair_iterations) / double(c.pair_solves), std::sqrt(sum[0] / sum[1]),
                    MPI_Wtime() - begin);
    }
    return PetscFinalize();
}
