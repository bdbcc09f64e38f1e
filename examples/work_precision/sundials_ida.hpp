// SPDX-License-Identifier: BSL-1.0
// SUNDIALS' IDA on M y' = f(t, y) with singular M.
#pragma once

#include <ida/ida.h>

#include <Eigen/LU>

#include "sundials.hpp"

namespace peers::sundials {

/// y = T w with w semi-explicit: w' of the components marked 1 in `differential` occurs in M T w', that of
/// the others, which multiply a basis of the kernel of M, does not.
struct semi_explicit_coordinates {
    Eigen::MatrixXd T;
    Eigen::VectorXd differential;
};
inline semi_explicit_coordinates semi_explicit(const Eigen::MatrixXd& mass) {
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(mass);
    const Eigen::Index n = mass.rows(), rank = lu.rank();
    semi_explicit_coordinates c{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
    const auto column = [&](Eigen::Index k) { return lu.permutationQ().indices()[k]; };
    for (Eigen::Index k = 0; k < rank; ++k) c.T(column(k), column(k)) = 1, c.differential[column(k)] = 1;
    if (rank < n) {
        const Eigen::MatrixXd kernel = lu.kernel();
        for (Eigen::Index k = rank; k < n; ++k) c.T.col(column(k)) = kernel.col(k - rank);
    }
    return c;
}

template <class Problem>
struct ida_data {
    const Problem* problem;
    jacobian_of<Problem> mass, T;
};

/// IDA is told which components are algebraic and corrects the initial values itself (IDA_YA_YDP_INIT) where
/// the index is 1, the case it is made for; the index-2 problem brings consistent ones. The algebraic
/// components are left out of the error test (IDASetSuppressAlg). With them in it the transistor amplifier
/// takes up to millions of steps: y6 + y7 follows y4 - y5 by a factor of about 170, every doubled step fails
/// on it, and IDA, at order 1 after three failures, raises the order only after constant steps.
template <class Problem>
outcome ida(const Problem& problem, double rtol, double t1) requires requires {
    problem.mass();
}
{
    context ctx;
    const Eigen::VectorXd y0 = problem.initial();
    const semi_explicit_coordinates coordinates = semi_explicit(problem.mass());
    ida_data<Problem> data{&problem, problem.mass() * coordinates.T, coordinates.T};
    const auto residual = [](realtype t, N_Vector w, N_Vector wp, N_Vector r, void* user) {
        const auto& d = *static_cast<ida_data<Problem>*>(user);
        thread_local state_of<Problem> in, out;
        in.noalias() = d.T * values(w);
        out.resize(in.size());
        (*d.problem)(t, in, out);
        values(r) = d.mass * values(wp) - out;
        return 0;
    };
    const auto jac = [](realtype t, realtype cj, N_Vector w, N_Vector, N_Vector, SUNMatrix J, void* user,
                        N_Vector, N_Vector, N_Vector) {
        const auto& d = *static_cast<ida_data<Problem>*>(user);
        thread_local state_of<Problem> in;
        thread_local jacobian_of<Problem> out;
        in.noalias() = d.T * values(w);
        out.resize(in.size(), in.size());
        d.problem->jacobian(t, in, out);
        Eigen::Map<Eigen::MatrixXd>(SM_DATA_D(J), out.rows(), out.cols()) = cj * d.mass - out * d.T;
        return 0;
    };
    state_of<Problem> start = y0, f(y0.size());
    problem(double(Problem::t0), start, f);
    const auto w = vector(coordinates.T.fullPivLu().solve(y0), ctx);
    const auto wp = vector(Eigen::MatrixXd(data.mass).fullPivLu().solve(Eigen::VectorXd(f)), ctx);
    const auto id = vector(coordinates.differential, ctx);
    void* memory = IDACreate(ctx.handle);
    IDAInit(memory, residual, Problem::t0, w.get(), wp.get());
    IDASStolerances(memory, rtol, rtol * Problem::atol_scale);
    IDASetUserData(memory, &data);
    IDASetMaxNumSteps(memory, 10'000'000);
    IDASetErrFile(memory, nullptr);
    IDASetId(memory, id.get());
    IDASetSuppressAlg(memory, SUNTRUE);
    const auto J = matrix(problem, y0.size(), ctx);
    const auto linear = solver(problem, w.get(), J.get(), ctx);
    IDASetLinearSolver(memory, linear.get(), J.get());
    IDASetJacFn(memory, jac);
    IDASetStopTime(memory, t1);
    int flag = 0;
    if constexpr (!requires { problem.index(); }) flag = IDACalcIC(memory, IDA_YA_YDP_INIT, t1);
    realtype t = Problem::t0;
    if (flag >= 0) flag = IDASolve(memory, t1, &t, w.get(), wp.get(), IDA_NORMAL);
    outcome out{.y = coordinates.T * values(w.get()), .ok = flag >= 0};
    IDAGetNumSteps(memory, &out.steps);
    IDAGetNumResEvals(memory, &out.f);
    IDAGetNumJacEvals(memory, &out.jacobians);
    IDAGetNumLinSolvSetups(memory, &out.factorisations);
    IDAFree(&memory);
    return out;
}

}  // namespace peers::sundials
