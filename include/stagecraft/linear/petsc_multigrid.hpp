// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <petscpc.h>

#include <stagecraft/linear/petsc_matrix.hpp>

namespace stagecraft::detail {

/// Makes pc what the options with prefix stage_pc_ say, by default algebraic multigrid: BoomerAMG where PETSc has hypre,
/// with two sweeps of Gauss-Seidel before and after, else PCGAMG. (Measured on a Laplacian in two dimensions, real
/// iterations to 1e-4: 2 with BoomerAMG, 3 with PCGAMG, whose setup takes three times as long; one sweep takes 3 and is
/// a third cheaper.)
inline void petsc_multigrid(PC pc) {
    const auto by_default = [](const char* name, const char* value) {
        PetscBool given = PETSC_FALSE;
        petsc_check(PetscOptionsHasName(nullptr, nullptr, name, &given));
        if (!given) petsc_check(PetscOptionsSetValue(nullptr, name, value));
    };
#ifdef PETSC_HAVE_HYPRE
    petsc_check(PCSetType(pc, PCHYPRE));
    by_default("-stage_pc_pc_hypre_boomeramg_relax_type_all", "SOR/Jacobi");
    by_default("-stage_pc_pc_hypre_boomeramg_grid_sweeps_all", "2");
#else
    petsc_check(PCSetType(pc, PCGAMG));
#endif
    // Shifts change by orders of magnitude from step to step, and with them what is coarse; smoothers that ask for
    // eigenvalues cost more than they gain; a finest level coarsened by more than the others costs N-dependence.
    by_default("-stage_pc_pc_gamg_reuse_interpolation", "false");
    by_default("-stage_pc_pc_gamg_square_graph", "0");
    by_default("-stage_pc_mg_levels_ksp_type", "richardson");
    by_default("-stage_pc_mg_levels_pc_type", "sor");
    petsc_check(PCSetOptionsPrefix(pc, "stage_pc_"));
}

}  // namespace stagecraft::detail
