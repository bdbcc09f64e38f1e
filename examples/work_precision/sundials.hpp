// SPDX-License-Identifier: BSL-1.0
// SUNDIALS: CVODE (BDF), IDA (BDF for M y' = f with singular M) and ARKODE (fifth-order ESDIRK), each with
// the problem's own Jacobian and a dense or banded direct solver.
#pragma once

#include <arkode/arkode_arkstep.h>
#include <cvode/cvode.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/LU>
#include <memory>

#include "run.hpp"

namespace peers::sundials {

struct context {
    context() { SUNContext_Create(nullptr, &handle); }
    ~context() { SUNContext_Free(&handle); }
    context(const context&) = delete;
    SUNContext handle = nullptr;
};

template <class T, class Free>
std::unique_ptr<std::remove_pointer_t<T>, Free> owned(T p, Free free) {
    return {p, free};
}

inline auto vector(const Eigen::VectorXd& y, const context& ctx) {
    auto v = owned(N_VNew_Serial(y.size(), ctx.handle), [](N_Vector p) { N_VDestroy(p); });
    Eigen::Map<Eigen::VectorXd>(N_VGetArrayPointer(v.get()), y.size()) = y;
    return v;
}
inline Eigen::Map<Eigen::VectorXd> values(N_Vector v) { return {N_VGetArrayPointer(v), N_VGetLength(v)}; }

template <class Problem>
constexpr bool banded = requires {
    Problem::lower;
};

template <class Problem>
auto matrix(const Problem&, Eigen::Index n, const context& ctx) {
    SUNMatrix m;
    if constexpr (banded<Problem>)
        m = SUNBandMatrix(n, Problem::upper, Problem::lower, ctx.handle);
    else
        m = SUNDenseMatrix(n, n, ctx.handle);
    return owned(m, [](SUNMatrix p) { SUNMatDestroy(p); });
}
template <class Problem>
auto solver(const Problem&, N_Vector y, SUNMatrix m, const context& ctx) {
    SUNLinearSolver s;
    if constexpr (banded<Problem>)
        s = SUNLinSol_Band(y, m, ctx.handle);
    else
        s = SUNLinSol_Dense(y, m, ctx.handle);
    return owned(s, [](SUNLinearSolver p) { SUNLinSolFree(p); });
}

template <class Problem>
int rhs(realtype t, N_Vector y, N_Vector f, void* user) {
    thread_local state_of<Problem> in, out;
    in = values(y);
    out.resize(in.size());
    (*static_cast<const Problem*>(user))(t, in, out);
    values(f) = out;
    return 0;
}

template <class Problem>
int jacobian(realtype t, N_Vector y, N_Vector, SUNMatrix J, void* user, N_Vector, N_Vector, N_Vector) {
    const auto& problem = *static_cast<const Problem*>(user);
    thread_local state_of<Problem> in;
    in = values(y);
    if constexpr (banded<Problem>) {
        SUNMatZero(J);
        problem.jacobian_entries(in, [&](int i, int j, double v) { SM_ELEMENT_B(J, i, j) = v; });
    } else {
        thread_local jacobian_of<Problem> out;
        out.resize(in.size(), in.size());
        problem.jacobian(t, in, out);
        Eigen::Map<Eigen::MatrixXd>(SM_DATA_D(J), out.rows(), out.cols()) = out;
    }
    return 0;
}

template <class Problem>
outcome cvode(const Problem& problem, double rtol, double t1) {
    context ctx;
    const Eigen::VectorXd y0 = problem.initial();
    const auto y = vector(y0, ctx);
    void* memory = CVodeCreate(CV_BDF, ctx.handle);
    CVodeInit(memory, rhs<Problem>, Problem::t0, y.get());
    CVodeSStolerances(memory, rtol, rtol * Problem::atol_scale);
    CVodeSetUserData(memory, const_cast<Problem*>(&problem));
    CVodeSetMaxNumSteps(memory, 10'000'000);
    CVodeSetErrFile(memory, nullptr);
    const auto J = matrix(problem, y0.size(), ctx);
    const auto linear = solver(problem, y.get(), J.get(), ctx);
    CVodeSetLinearSolver(memory, linear.get(), J.get());
    CVodeSetJacFn(memory, jacobian<Problem>);
    CVodeSetStopTime(memory, t1);
    realtype t = Problem::t0;
    const int flag = CVode(memory, t1, y.get(), &t, CV_NORMAL);
    outcome out{.y = values(y.get()), .ok = flag >= 0};
    CVodeGetNumSteps(memory, &out.steps);
    CVodeGetNumRhsEvals(memory, &out.f);
    CVodeGetNumJacEvals(memory, &out.jacobians);
    CVodeGetNumLinSolvSetups(memory, &out.factorisations);
    CVodeFree(&memory);
    return out;
}

/// ARKODE's default diagonally implicit method (order 4); M y' = f is not asked of it.
template <class Problem>
outcome arkode(const Problem& problem, double rtol, double t1) {
    context ctx;
    const Eigen::VectorXd y0 = problem.initial();
    const auto y = vector(y0, ctx);
    void* memory = ARKStepCreate(nullptr, rhs<Problem>, Problem::t0, y.get(), ctx.handle);
    ARKStepSStolerances(memory, rtol, rtol * Problem::atol_scale);
    ARKStepSetUserData(memory, const_cast<Problem*>(&problem));
    ARKStepSetMaxNumSteps(memory, 10'000'000);
    ARKStepSetErrFile(memory, nullptr);
    const auto J = matrix(problem, y0.size(), ctx);
    const auto linear = solver(problem, y.get(), J.get(), ctx);
    ARKStepSetLinearSolver(memory, linear.get(), J.get());
    ARKStepSetJacFn(memory, jacobian<Problem>);
    ARKStepSetStopTime(memory, t1);
    realtype t = Problem::t0;
    const int flag = ARKStepEvolve(memory, t1, y.get(), &t, ARK_NORMAL);
    outcome out{.y = values(y.get()), .ok = flag >= 0};
    long explicit_f = 0;
    ARKStepGetNumSteps(memory, &out.steps);
    ARKStepGetNumRhsEvals(memory, &explicit_f, &out.f);
    ARKStepGetNumJacEvals(memory, &out.jacobians);
    ARKStepGetNumLinSolvSetups(memory, &out.factorisations);
    ARKStepFree(&memory);
    return out;
}

template <class Problem>
struct ida_data {
    const Problem* problem;
    Eigen::MatrixXd mass;
};

template <class Problem>
outcome ida(const Problem& problem, double rtol, double t1) requires requires {
    problem.mass();
}
{
    context ctx;
    const Eigen::VectorXd y0 = problem.initial();
    ida_data<Problem> data{&problem, problem.mass()};
    const auto residual = [](realtype t, N_Vector y, N_Vector yp, N_Vector r, void* user) {
        const auto& d = *static_cast<ida_data<Problem>*>(user);
        thread_local state_of<Problem> in, out;
        in = values(y);
        out.resize(in.size());
        (*d.problem)(t, in, out);
        values(r) = d.mass * values(yp) - out;
        return 0;
    };
    const auto jac = [](realtype t, realtype cj, N_Vector y, N_Vector, N_Vector, SUNMatrix J, void* user,
                        N_Vector, N_Vector, N_Vector) {
        const auto& d = *static_cast<ida_data<Problem>*>(user);
        thread_local state_of<Problem> in;
        thread_local jacobian_of<Problem> out;
        in = values(y);
        out.resize(in.size(), in.size());
        d.problem->jacobian(t, in, out);
        Eigen::Map<Eigen::MatrixXd>(SM_DATA_D(J), out.rows(), out.cols()) = cj * d.mass - out;
        return 0;
    };
    const auto y = vector(y0, ctx);
    state_of<Problem> f(y0.size()), start = y0;
    problem(double(Problem::t0), start, f);
    // M y' = f has many solutions y' where M is singular; IDA starts from the one of least norm.
    const auto yp = vector(data.mass.fullPivLu().solve(Eigen::VectorXd(f)), ctx);
    void* memory = IDACreate(ctx.handle);
    IDAInit(memory, residual, Problem::t0, y.get(), yp.get());
    IDASStolerances(memory, rtol, rtol * Problem::atol_scale);
    IDASetUserData(memory, &data);
    IDASetMaxNumSteps(memory, 10'000'000);
    IDASetErrFile(memory, nullptr);
    const auto J = matrix(problem, y0.size(), ctx);
    const auto linear = solver(problem, y.get(), J.get(), ctx);
    IDASetLinearSolver(memory, linear.get(), J.get());
    IDASetJacFn(memory, jac);
    IDASetStopTime(memory, t1);
    realtype t = Problem::t0;
    const int flag = IDASolve(memory, t1, &t, y.get(), yp.get(), IDA_NORMAL);
    outcome out{.y = values(y.get()), .ok = flag >= 0};
    IDAGetNumSteps(memory, &out.steps);
    IDAGetNumResEvals(memory, &out.f);
    IDAGetNumJacEvals(memory, &out.jacobians);
    IDAGetNumLinSolvSetups(memory, &out.factorisations);
    IDAFree(&memory);
    return out;
}

}  // namespace peers::sundials
