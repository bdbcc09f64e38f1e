// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <petscdmda.h>

#include <Eigen/Core>
#include <cmath>
#include <problems/petsc_counted.hpp>
#include <stagecraft/linear/petsc.hpp>

// The Brusselator with diffusion on a periodic N x N grid of the unit square (Hairer-Wanner II.IV.10, "BRUSS-2D",
// diffusion 1/10, without the source that sets in later), distributed by PETSc's DMDA: 2 N^2 unknowns.
class brusselator_2d {
  public:
    using linear_solver = stagecraft::petsc_blocks;
    using vector = Eigen::VectorXd;

    explicit brusselator_2d(PetscInt n, MPI_Comm processes = PETSC_COMM_WORLD)
        : processes_(processes), n_(n), diffusion_(0.1 * static_cast<double>(n) * static_cast<double>(n)) {
        using stagecraft::petsc_check, stagecraft::petsc_made;
        grid_ = petsc_made<DM>([&](DM* dm) {
            return DMDACreate2d(processes, DM_BOUNDARY_PERIODIC, DM_BOUNDARY_PERIODIC, DMDA_STENCIL_STAR, n,
                                n, PETSC_DECIDE, PETSC_DECIDE, 2, 1, nullptr, nullptr, dm);
        });
        const PetscInt both[] = {1, 1, 1, 1}, alike[] = {1, 0, 0, 1};  // u and v meet in one point only
        petsc_check(DMDASetBlockFills(grid_.get(), both, alike));
        petsc_check(DMSetUp(grid_.get()));
        petsc_check(DMDAGetCorners(grid_.get(), &x_, &y_, nullptr, &width_, &height_, nullptr));
        state_ = petsc_made<Vec>([&](Vec* v) { return DMCreateGlobalVector(grid_.get(), v); });
        around_ = petsc_made<Vec>([&](Vec* v) { return DMCreateLocalVector(grid_.get(), v); });
    }

    MPI_Comm processes() const { return processes_; }
    Vec layout() const { return state_.get(); }
    void add_up(double* x, int k) const { stagecraft::petsc_add_up(processes(), x, k); }

    vector start() const {
        vector y(2 * width_ * height_);
        each([&](PetscInt i, PetscInt j, PetscInt at) {
            const double p = static_cast<double>(i) / n_, q = static_cast<double>(j) / n_;
            y[at] = 22 * q * std::pow(1 - q, 1.5);
            y[at + 1] = 27 * p * std::pow(1 - p, 1.5);
        });
        return y;
    }
    /// The constant state with f = 0.
    vector equilibrium() const {
        vector y(2 * width_ * height_);
        for (Eigen::Index i = 0; i < y.size(); i += 2) y[i] = 1, y[i + 1] = 3.4;
        return y;
    }
    void operator()(double, const vector& y, vector& f) const { evaluate(y.data(), f.data()); }
    /// f(y) on local parts.
    void evaluate(const double* y, double* f) const {
        using stagecraft::petsc_check;
        {
            const stagecraft::petsc_view view(state_.get(), y);
            petsc_check(DMGlobalToLocal(grid_.get(), state_.get(), INSERT_VALUES, around_.get()));
        }
        const double* w = nullptr;
        petsc_check(VecGetArrayRead(around_.get(), &w));
        const PetscInt row = 2 * (width_ + 2);
        each([&](PetscInt i, PetscInt j, PetscInt at) {
            const double* z = w + (j - y_ + 1) * row + 2 * (i - x_ + 1);
            const double u = z[0], v = z[1], uuv = u * u * v;
            f[at] = 1 + uuv - 4.4 * u + diffusion_ * (z[2] + z[-2] + z[row] + z[-row] - 4 * u);
            f[at + 1] = 3.4 * u - uuv + diffusion_ * (z[3] + z[-1] + z[row + 1] + z[1 - row] - 4 * v);
        });
        petsc_check(VecRestoreArrayRead(around_.get(), &w));
    }

    /// With the part of the diffusion, which stays.
    stagecraft::petsc_matrix matrix() const {
        using stagecraft::petsc_check;
        const auto J = stagecraft::petsc_made<Mat>([&](Mat* A) { return DMCreateMatrix(grid_.get(), A); });
        each([&](PetscInt i, PetscInt j, PetscInt) {
            for (PetscInt c = 0; c < 2; ++c) {
                const MatStencil here{0, j, i, c},
                    next[] = {{0, j, i - 1, c}, {0, j, i + 1, c}, {0, j - 1, i, c}, {0, j + 1, i, c}};
                const double values[] = {diffusion_, diffusion_, diffusion_, diffusion_};
                petsc_check(MatSetValuesStencil(J.get(), 1, &here, 4, next, values, INSERT_VALUES));
            }
        });
        fill(start().data(), J.get());
        return stagecraft::petsc_matrix(J.get());
    }
    void jacobian(double, const vector& y, stagecraft::petsc_matrix& J) const { fill(y.data(), J.get()); }
    /// What matrix() has left open: the reaction and the diagonal.
    void fill(const double* y, Mat J) const {
        using stagecraft::petsc_check;
        each([&](PetscInt i, PetscInt j, PetscInt at) {
            const double u = y[at], v = y[at + 1];
            const MatStencil point[] = {{0, j, i, 0}, {0, j, i, 1}};
            const double values[] = {2 * u * v - 4.4 - 4 * diffusion_, u * u, 3.4 - 2 * u * v,
                                     -u * u - 4 * diffusion_};
            petsc_check(MatSetValuesStencil(J, 2, point, 2, point, values, INSERT_VALUES));
        });
        petsc_check(MatAssemblyBegin(J, MAT_FINAL_ASSEMBLY));
        petsc_check(MatAssemblyEnd(J, MAT_FINAL_ASSEMBLY));
    }

  private:
    /// Calls visit(i, j, place of u in the local part) for every point of this process.
    template <class Visit>
    void each(Visit&& visit) const {
        PetscInt at = 0;
        for (PetscInt j = y_; j < y_ + height_; ++j)
            for (PetscInt i = x_; i < x_ + width_; ++i, at += 2) visit(i, j, at);
    }

    MPI_Comm processes_;
    PetscInt n_, x_ = 0, y_ = 0, width_ = 0, height_ = 0;
    double diffusion_;
    stagecraft::petsc_owned<DM> grid_;
    stagecraft::petsc_owned<Vec> state_, around_;
};

using counted_brusselator = petsc_counted<brusselator_2d>;
