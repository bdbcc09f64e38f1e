// SPDX-License-Identifier: BSL-1.0
// The same problem by CVODE and by PETSc's own steppers, with the same multigrid.
#include <petscts.h>

#include "contest.hpp"

#ifdef HAVE_SUNDIALS
#include <cvode/cvode.h>
#include <nvector/nvector_parallel.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#endif

namespace sc = stagecraft;
using sc::petsc_check;

#ifdef HAVE_SUNDIALS
namespace {

struct cvode_problem {
    const brusselator_2d& problem;
    sc::petsc_matrix J = problem.matrix();
    sc::detail::petsc_shifted system{};
    sc::petsc_owned<Vec> in{}, out{};
    double gamma = 0;

    static cvode_problem& of(void* data) { return *static_cast<cvode_problem*>(data); }
    static int f(double, N_Vector y, N_Vector out, void* data) {
        of(data).problem.evaluate(N_VGetArrayPointer(y), N_VGetArrayPointer(out));
        return 0;
    }
    static int setup(double, N_Vector y, N_Vector, int kept, int* current, double gamma, void* data) {
        auto& my = of(data);
        if (!kept) my.problem.fill(N_VGetArrayPointer(y), my.J.get());
        *current = !kept;
        my.gamma = gamma;
        if (!my.system.set(nullptr, my.J, 1 / gamma)) return 1;
        if (!my.in) my.in = my.system.vector(), my.out = my.system.vector();
        return 0;
    }
    static int solve(double, N_Vector, N_Vector, N_Vector r, N_Vector z, double, double, int, void* data) {
        auto& my = of(data);
        const sc::petsc_view in(my.in.get(), N_VGetArrayPointer(r)), out(my.out.get(), N_VGetArrayPointer(z));
        my.system.cycle(my.in.get(), my.out.get());
        petsc_check(VecScale(my.out.get(), 1 / my.gamma));
        return 0;
    }
};

}  // namespace

outcome run_cvode(double tolerance, double t1, int grid) {
    const brusselator_2d problem(grid);
    cvode_problem data{problem};
    outcome result;
    result.y = problem.start();
    MPI_Comm processes = problem.processes();
    SUNContext context = nullptr;
    SUNContext_Create(&processes, &context);
    N_Vector y = N_VMake_Parallel(processes, result.y.size(), 2L * grid * grid, result.y.data(), context);
    void* solver = CVodeCreate(CV_BDF, context);
    SUNLinearSolver linear = SUNLinSol_SPGMR(y, SUN_PREC_RIGHT, 0, context);
    double t = 0;
    const bool ready = CVodeInit(solver, cvode_problem::f, 0, y) == 0 &&
                       CVodeSStolerances(solver, tolerance, tolerance) == 0 &&
                       CVodeSetUserData(solver, &data) == 0 && CVodeSetMaxNumSteps(solver, 1000000) == 0 &&
                       CVodeSetLinearSolver(solver, linear, nullptr) == 0 &&
                       CVodeSetPreconditioner(solver, cvode_problem::setup, cvode_problem::solve) == 0 &&
                       CVodeSetStopTime(solver, t1) == 0;
    result.reached = ready && CVode(solver, t1, y, &t, CV_NORMAL) >= 0 && t == t1;
    CVodeGetNumSteps(solver, &result.steps);
    result.cycles = data.J.counts().cycles;
    result.setups = data.J.counts().setups;
    SUNLinSolFree(linear);
    CVodeFree(&solver);
    N_VDestroy(y);
    SUNContext_Free(&context);
    return result;
}
#endif

namespace {

struct ts_problem {
    const brusselator_2d& problem;
    sc::petsc_matrix J = problem.matrix();
    long setups = 0;

    // F(t, y, y') = y' - f(y)
    static PetscErrorCode residual(TS, PetscReal, Vec y, Vec slope, Vec out, void* data) {
        const double* from = nullptr;
        double* to = nullptr;
        petsc_check(VecGetArrayRead(y, &from));
        petsc_check(VecGetArray(out, &to));
        static_cast<ts_problem*>(data)->problem.evaluate(from, to);
        petsc_check(VecRestoreArray(out, &to));
        petsc_check(VecRestoreArrayRead(y, &from));
        return VecAYPX(out, -1, slope);
    }
    static PetscErrorCode jacobian(TS, PetscReal, Vec y, Vec, PetscReal shift, Mat A, Mat, void* data) {
        auto& my = *static_cast<ts_problem*>(data);
        ++my.setups;
        const double* at = nullptr;
        petsc_check(VecGetArrayRead(y, &at));
        my.problem.fill(at, my.J.get());
        petsc_check(VecRestoreArrayRead(y, &at));
        petsc_check(MatCopy(my.J.get(), A, SAME_NONZERO_PATTERN));
        petsc_check(MatScale(A, -1));
        return MatShift(A, shift);
    }
};

}  // namespace

outcome run_petsc(const char* type, double tolerance, double t1, int grid) {
    const brusselator_2d problem(grid);
    ts_problem data{problem};
    outcome result;
    result.y = problem.start();
    const auto ts = sc::petsc_made<TS>([&](TS* made) { return TSCreate(problem.processes(), made); });
    const auto A =
        sc::petsc_made<Mat>([&](Mat* made) { return MatDuplicate(data.J.get(), MAT_COPY_VALUES, made); });
    const auto y = sc::petsc_made<Vec>([&](Vec* made) { return MatCreateVecs(A.get(), made, nullptr); });
    petsc_check(TSSetType(ts.get(), type));
    if (std::string(type) == TSBDF) petsc_check(TSBDFSetOrder(ts.get(), 4));
    if (std::string(type) == TSARKIMEX) {
        petsc_check(TSARKIMEXSetType(ts.get(), TSARKIMEX4));
        petsc_check(TSARKIMEXSetFullyImplicit(ts.get(), PETSC_TRUE));
    }
    if (std::string(type) == TSROSW) petsc_check(TSRosWSetType(ts.get(), TSROSWRODAS3));
    petsc_check(TSSetIFunction(ts.get(), nullptr, ts_problem::residual, &data));
    petsc_check(TSSetIJacobian(ts.get(), A.get(), A.get(), ts_problem::jacobian, &data));
    petsc_check(TSSetTolerances(ts.get(), tolerance, nullptr, tolerance, nullptr));
    petsc_check(TSSetTimeStep(ts.get(), 1e-3 * std::sqrt(tolerance)));
    petsc_check(TSSetMaxTime(ts.get(), t1));
    petsc_check(TSSetMaxSteps(ts.get(), 4000));
    petsc_check(TSSetMaxSNESFailures(ts.get(), -1));
    petsc_check(TSSetMaxStepRejections(ts.get(), -1));
    petsc_check(TSSetExactFinalTime(ts.get(), TS_EXACTFINALTIME_MATCHSTEP));
    SNES newton = nullptr;
    KSP krylov = nullptr;
    PC multigrid = nullptr;
    petsc_check(TSGetSNES(ts.get(), &newton));
    petsc_check(SNESSetTolerances(newton, PETSC_DEFAULT, 1e-4, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT));
    petsc_check(SNESGetKSP(newton, &krylov));
    petsc_check(KSPSetType(krylov, KSPFGMRES));
    // Newton's iteration corrects what a solve leaves, a Rosenbrock method does not.
    petsc_check(KSPSetTolerances(krylov, std::string(type) == TSROSW ? 1e-4 : 1e-2, PETSC_DEFAULT,
                                 PETSC_DEFAULT, PETSC_DEFAULT));
    petsc_check(KSPGetPC(krylov, &multigrid));
    sc::detail::petsc_multigrid(multigrid);
    petsc_check(PCSetFromOptions(multigrid));
    {
        const double* start = result.y.data();
        double* to = nullptr;
        petsc_check(VecGetArray(y.get(), &to));
        std::copy(start, start + result.y.size(), to);
        petsc_check(VecRestoreArray(y.get(), &to));
    }
    if (TSSolve(ts.get(), y.get()) != 0) return result;
    PetscReal t = 0;
    PetscInt steps = 0, cycles = 0;
    petsc_check(TSGetSolveTime(ts.get(), &t));
    petsc_check(TSGetStepNumber(ts.get(), &steps));
    petsc_check(TSGetKSPIterations(ts.get(), &cycles));
    const double* end = nullptr;
    petsc_check(VecGetArrayRead(y.get(), &end));
    result.y = Eigen::Map<const Eigen::VectorXd>(end, result.y.size());
    petsc_check(VecRestoreArrayRead(y.get(), &end));
    result.reached = std::abs(t - t1) <= 1e-12 * t1;
    result.steps = steps;
    result.cycles = cycles;
    result.setups = data.setups;
    return result;
}
