// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <petscksp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <stagecraft/linear/linear_solve.hpp>
#include <stagecraft/linear/petsc_matrix.hpp>

namespace stagecraft::detail {

/// Flexible GMRES, from the right and from zero, to a hundredth of the residual or to what the options say.
class petsc_iteration {
  public:
    bool made() const { return static_cast<bool>(ksp_); }
    /// For the matrix A, preconditioned by object->precondition(in, out), with this prefix of its options.
    template <class Object>
    void make(const char* prefix, Mat A, Object* object) {
        MPI_Comm processes = MPI_COMM_NULL;
        petsc_check(PetscObjectGetComm(reinterpret_cast<PetscObject>(A), &processes));
        ksp_ = petsc_made<KSP>([&](KSP* k) { return KSPCreate(processes, k); });
        petsc_check(KSPSetType(ksp_.get(), KSPFGMRES));
        petsc_check(KSPSetTolerances(ksp_.get(), 1e-2, 0, PETSC_DEFAULT, 60));
        petsc_check(KSPSetOptionsPrefix(ksp_.get(), prefix));
        set_matrix(A);
        PC pc = nullptr;
        petsc_check(KSPGetPC(ksp_.get(), &pc));
        petsc_check(PCSetType(pc, PCSHELL));
        petsc_check(PCShellSetContext(pc, object));
        petsc_check(PCShellSetApply(pc, [](PC shell, Vec in, Vec out) -> PetscErrorCode {
            void* context = nullptr;
            if (const PetscErrorCode code = PCShellGetContext(shell, &context)) return code;
            return petsc_code([&] { static_cast<Object*>(context)->precondition(in, out); });
        }));
        petsc_check(KSPSetFromOptions(ksp_.get()));
        petsc_check(KSPGetTolerances(ksp_.get(), &bound_, &least_, &divergence_, &most_));
        for (auto* v : {&rhs_, &solution_})
            *v = petsc_made<Vec>([&](Vec* x) { return MatCreateVecs(A, x, nullptr); });
    }
    /// The part of a residual that is left where nothing else is said.
    double usual_part() const { return bound_; }
    void set_matrix(Mat A) { petsc_check(KSPSetOperators(ksp_.get(), A, A)); }

    /// Solves in the memory of x, the local part of the right-hand side, of whose size `part` may be left. NaN on all
    /// processes where the iteration breaks down or does not come so far: whoever asks refuses the step.
    linear_solve solve(double* x, double part) {
        petsc_check(KSPSetTolerances(ksp_.get(), std::max(bound_, part), least_, divergence_, most_));
        PetscInt n = 0;
        petsc_check(VecGetLocalSize(rhs_.get(), &n));
        double* r = nullptr;
        petsc_check(VecGetArrayWrite(rhs_.get(), &r));
        std::memcpy(r, x, sizeof(double) * static_cast<std::size_t>(n));
        petsc_check(VecRestoreArrayWrite(rhs_.get(), &r));
        const petsc_view out(solution_.get(), x);
        petsc_check(KSPSolve(ksp_.get(), rhs_.get(), solution_.get()));
        KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
        petsc_check(KSPGetConvergedReason(ksp_.get(), &reason));
        PetscInt iterations = 0;
        petsc_check(KSPGetIterationNumber(ksp_.get(), &iterations));
        linear_solve done{static_cast<int>(iterations), linear_end::solved};
        if (reason < 0) {
            done.end = why(reason);
            petsc_check(VecSet(solution_.get(), std::numeric_limits<double>::quiet_NaN()));
        }
        return done;
    }
    /// x := the right-hand side of the last solve.
    void give_back(double* x) const {
        const double* r = nullptr;
        PetscInt n = 0;
        petsc_check(VecGetLocalSize(rhs_.get(), &n));
        petsc_check(VecGetArrayRead(rhs_.get(), &r));
        std::memcpy(x, r, sizeof(double) * static_cast<std::size_t>(n));
        petsc_check(VecRestoreArrayRead(rhs_.get(), &r));
    }

  private:
    linear_end why(KSPConvergedReason reason) const {
        if (reason == KSP_DIVERGED_PC_FAILED) return linear_end::bad_preconditioner;
        if (reason != KSP_DIVERGED_NANORINF) return linear_end::unconverged;
        PetscReal size = 0;
        petsc_check(VecNorm(rhs_.get(), NORM_2, &size));
        return std::isfinite(size) ? linear_end::bad_preconditioner : linear_end::not_finite;
    }

    petsc_owned<KSP> ksp_;
    petsc_owned<Vec> rhs_, solution_;
    PetscReal bound_ = 0, least_ = 0, divergence_ = 0;
    PetscInt most_ = 0;
};

}  // namespace stagecraft::detail
