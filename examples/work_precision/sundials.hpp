// SPDX-License-Identifier: BSL-1.0
// SUNDIALS' CVODE, with the problem's own Jacobian and a dense or banded direct solver: BDF with Newton's
// method, or Adams-Moulton with fixed-point iteration on a nonstiff problem, as its manual recommends.
#pragma once

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

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
constexpr bool nonstiff = requires {
    Problem::nonstiff;
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
    void* memory = CVodeCreate(nonstiff<Problem> ? CV_ADAMS : CV_BDF, ctx.handle);
    CVodeInit(memory, rhs<Problem>, Problem::t0, y.get());
    CVodeSStolerances(memory, rtol, rtol * Problem::atol_scale);
    CVodeSetUserData(memory, const_cast<Problem*>(&problem));
    CVodeSetMaxNumSteps(memory, 10'000'000);
    CVodeSetErrFile(memory, nullptr);
    const auto J = matrix(problem, y0.size(), ctx);
    const auto linear = solver(problem, y.get(), J.get(), ctx);
    const auto fixed_point = owned(SUNNonlinSol_FixedPoint(y.get(), 0, ctx.handle),
                                   [](SUNNonlinearSolver p) { SUNNonlinSolFree(p); });
    if constexpr (nonstiff<Problem>) {
        CVodeSetNonlinearSolver(memory, fixed_point.get());
    } else {
        CVodeSetLinearSolver(memory, linear.get(), J.get());
        CVodeSetJacFn(memory, jacobian<Problem>);
    }
    CVodeSetStopTime(memory, t1);
    realtype t = Problem::t0;
    const int flag = CVode(memory, t1, y.get(), &t, CV_NORMAL);
    outcome out{.y = values(y.get()), .ok = flag >= 0};
    CVodeGetNumSteps(memory, &out.steps);
    CVodeGetNumRhsEvals(memory, &out.f);
    if constexpr (!nonstiff<Problem>) {
        CVodeGetNumJacEvals(memory, &out.jacobians);
        CVodeGetNumLinSolvSetups(memory, &out.factorisations);
    }
    CVodeFree(&memory);
    return out;
}

}  // namespace peers::sundials
