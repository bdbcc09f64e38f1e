// SPDX-License-Identifier: BSL-1.0
// SUNDIALS' ARKODE. Its mass matrix has to be regular (manual, section "Mathematical considerations"), so
// that it takes no part in the problems with constraints.
#pragma once

#include <arkode/arkode_arkstep.h>

#include "sundials.hpp"

namespace peers::sundials {

/// ESDIRK4(3)6L[2]SA, which later versions of ARKODE made the default of order 4, or Fehlberg 8(7) on a
/// nonstiff problem. Two settings differ from the defaults, both made for stiff problems:
/// - f at a stage is deduced from the stage instead of evaluated: the evaluation multiplies what Newton's
///   method has left of the error by the stiffness, which costs ten to a hundred times the steps;
/// - stages are predicted from the interpolant of the last step, not from its end value.
template <class Problem>
outcome arkode(const Problem& problem, double rtol, double t1) {
    context ctx;
    const Eigen::VectorXd y0 = problem.initial();
    const auto y = vector(y0, ctx);
    ARKRhsFn f = rhs<Problem>;
    void* memory = nonstiff<Problem> ? ARKStepCreate(f, nullptr, Problem::t0, y.get(), ctx.handle)
                                     : ARKStepCreate(nullptr, f, Problem::t0, y.get(), ctx.handle);
    ARKStepSStolerances(memory, rtol, rtol * Problem::atol_scale);
    ARKStepSetUserData(memory, const_cast<Problem*>(&problem));
    ARKStepSetMaxNumSteps(memory, 10'000'000);
    ARKStepSetErrFile(memory, nullptr);
    const auto J = matrix(problem, y0.size(), ctx);
    const auto linear = solver(problem, y.get(), J.get(), ctx);
    if constexpr (nonstiff<Problem>) {
        ARKStepSetTableNum(memory, ARKODE_DIRK_NONE, ARKODE_FEHLBERG_13_7_8);
    } else {
        ARKStepSetTableNum(memory, ARKODE_ESDIRK436L2SA_6_3_4, ARKODE_ERK_NONE);
        ARKStepSetDeduceImplicitRhs(memory, SUNTRUE);
        ARKStepSetPredictorMethod(memory, 1);
        ARKStepSetLinearSolver(memory, linear.get(), J.get());
        ARKStepSetJacFn(memory, jacobian<Problem>);
    }
    ARKStepSetStopTime(memory, t1);
    realtype t = Problem::t0;
    const int flag = ARKStepEvolve(memory, t1, y.get(), &t, ARK_NORMAL);
    outcome out{.y = values(y.get()), .ok = flag >= 0};
    long explicit_f = 0;
    ARKStepGetNumSteps(memory, &out.steps);
    ARKStepGetNumRhsEvals(memory, &explicit_f, &out.f);
    out.f += explicit_f;
    if constexpr (!nonstiff<Problem>) {
        ARKStepGetNumJacEvals(memory, &out.jacobians);
        ARKStepGetNumLinSolvSetups(memory, &out.factorisations);
    }
    ARKStepFree(&memory);
    return out;
}

}  // namespace peers::sundials
