// SPDX-License-Identifier: BSL-1.0
// SUNDIALS' ARKODE on a problem in two parts.
#pragma once

#include <arkode/arkode_arkstep.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include "sundials.hpp"

namespace peers::sundials {

template <class P>
constexpr bool is_sparse = requires {
    P::klu;
};

template <class P, bool Fast>
int part(realtype t, N_Vector y, N_Vector f, void* user) {
    thread_local typename P::state in, out;
    in = values(y);
    out.resize(in.size());
    const auto& p = *static_cast<const P*>(user);
    if constexpr (Fast)
        p.fast(t, in, out);
    else
        p.slow(t, in, out);
    values(f) = out;
    return 0;
}

template <class P>
int fast_jacobian(realtype, N_Vector y, N_Vector, SUNMatrix J, void* user, N_Vector, N_Vector, N_Vector) {
    const auto& p = *static_cast<const P*>(user);
    if constexpr (requires { p.matrix(); }) {
        static const Eigen::SparseMatrix<double> A = p.matrix();
        SUNMatZero(J);
        if constexpr (is_sparse<P>) {
            std::copy_n(A.outerIndexPtr(), A.cols() + 1, SM_INDEXPTRS_S(J));
            std::copy_n(A.innerIndexPtr(), A.nonZeros(), SM_INDEXVALS_S(J));
            std::copy_n(A.valuePtr(), A.nonZeros(), SM_DATA_S(J));
        } else {
            for (int j = 0; j < A.outerSize(); ++j)
                for (Eigen::SparseMatrix<double>::InnerIterator e(A, j); e; ++e)
                    SM_ELEMENT_B(J, e.row(), e.col()) = e.value();
        }
    } else {
        Eigen::Matrix2d of_small;
        p.jacobian(typename P::state(values(y)), of_small);
        Eigen::Map<Eigen::Matrix2d>{SM_DATA_D(J)} = of_small;
    }
    return 0;
}

/// ARK324L2SA, ARK436L2SA or ARK548L2SA. Where the implicit part is linear with a matrix that does not change ARKODE is told
/// so; stages are predicted from the last step's interpolant, which saves it iterations where the part is not linear.
template <class P>
outcome imex(const P& p, int order, double tolerance) {
    context ctx;
    const Eigen::VectorXd y0 = p.initial();
    const auto y = vector(y0, ctx);
    void* memory = ARKStepCreate(part<P, false>, part<P, true>, 0, y.get(), ctx.handle);
    ARKStepSStolerances(memory, tolerance, tolerance);
    ARKStepSetUserData(memory, const_cast<P*>(&p));
    ARKStepSetMaxNumSteps(memory, 10'000'000);
    ARKStepSetErrFile(memory, nullptr);
    if (order == 3) ARKStepSetTableNum(memory, ARKODE_ARK324L2SA_DIRK_4_2_3, ARKODE_ARK324L2SA_ERK_4_2_3);
    if (order == 4) ARKStepSetTableNum(memory, ARKODE_ARK436L2SA_DIRK_6_3_4, ARKODE_ARK436L2SA_ERK_6_3_4);
    if (order == 5) ARKStepSetTableNum(memory, ARKODE_ARK548L2SA_DIRK_8_4_5, ARKODE_ARK548L2SA_ERK_8_4_5);
    const auto free_matrix = [](SUNMatrix m) { SUNMatDestroy(m); };
    const auto free_solver = [](SUNLinearSolver s) { SUNLinSolFree(s); };
    const auto n = y0.size();
    auto J = owned(SUNMatrix(nullptr), free_matrix);
    auto linear = owned(SUNLinearSolver(nullptr), free_solver);
    if constexpr (is_sparse<P>) {
        static const auto entries = p.matrix().nonZeros();
        J.reset(SUNSparseMatrix(n, n, entries + n, CSC_MAT, ctx.handle));
        linear.reset(SUNLinSol_KLU(y.get(), J.get(), ctx.handle));
    } else if constexpr (requires { P::lower; }) {
        J.reset(SUNBandMatrix(n, P::upper, P::lower, ctx.handle));
        linear.reset(SUNLinSol_Band(y.get(), J.get(), ctx.handle));
    } else {
        J.reset(SUNDenseMatrix(n, n, ctx.handle));
        linear.reset(SUNLinSol_Dense(y.get(), J.get(), ctx.handle));
    }
    ARKStepSetLinearSolver(memory, linear.get(), J.get());
    ARKStepSetJacFn(memory, fast_jacobian<P>);
    if constexpr (requires { p.matrix(); })
        ARKStepSetLinear(memory, 0);
    else
        ARKStepSetPredictorMethod(memory, 1);
    ARKStepSetStopTime(memory, P::t1);
    realtype t = 0;
    const int flag = ARKStepEvolve(memory, P::t1, y.get(), &t, ARK_NORMAL);
    outcome out{.y = values(y.get()), .ok = flag >= 0};
    long slow = 0, fast = 0;
    ARKStepGetNumStepAttempts(memory, &out.steps);
    ARKStepGetNumRhsEvals(memory, &slow, &fast);
    out.f = slow + fast;
    ARKStepGetNumJacEvals(memory, &out.jacobians);
    ARKStepGetNumLinSolvSetups(memory, &out.factorisations);
    ARKStepFree(&memory);
    return out;
}

}  // namespace peers::sundials
