// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <petscdmda.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <problems/petsc_counted.hpp>
#include <stagecraft/linear/petsc.hpp>
#include <string>
#include <utility>
#include <vector>

// Incompressible flow (Navier-Stokes) through the unit square on a staggered N x N grid: a DAE of index 2,
//
//     u' = -div(u u) + nu Lap u - grad p,    0 = -div u,
//
// with the pressure in the middle of the cells and the normal velocities on their sides (Harlow and Welch's marker-and-cell
// grid). The velocity is given at the left and at the lower side, the pressure at the right and at the upper one, all
// from the solution: a lattice of decaying vortices (G. I. Taylor's) carried by a stream whose velocity changes. It solves
// the equations on the grid as well, once the vortices decay and travel as the grid lets them, so that no error is
// that of the discretisation in space. Since the flow through the sides changes with time, so does what the constraint
// says of the stages, and the pressure shows the order of index 2.
class incompressible_flow {
  public:
    using linear_solver = stagecraft::petsc_blocks;
    using vector = Eigen::VectorXd;

    explicit incompressible_flow(PetscInt n, double viscosity = 0.002, MPI_Comm processes = PETSC_COMM_WORLD)
        : processes_(processes), n_(n), viscosity_(viscosity) {
        using stagecraft::petsc_check, stagecraft::petsc_made;
        grid_ = petsc_made<DM>([&](DM* dm) {
            return DMDACreate2d(processes, DM_BOUNDARY_GHOSTED, DM_BOUNDARY_GHOSTED, DMDA_STENCIL_BOX, n, n,
                                PETSC_DECIDE, PETSC_DECIDE, 3, 1, nullptr, nullptr, dm);
        });
        petsc_check(DMSetUp(grid_.get()));
        petsc_check(DMDAGetCorners(grid_.get(), &x_, &y_, nullptr, &width_, &height_, nullptr));
        state_ = petsc_made<Vec>([&](Vec* v) { return DMCreateGlobalVector(grid_.get(), v); });
        around_ = petsc_made<Vec>([&](Vec* v) { return DMCreateLocalVector(grid_.get(), v); });
    }

    /// Cell (i, j) has three numbers: u in the middle of its right side, v in that of its upper side, p inside.
    struct cell {
        double u, v, p;
    };
    cell solution(double t, PetscInt i, PetscInt j) const {
        const double h = step(), k = wave, left = (double(i) + 0.5) * h, right = double(i + 1) * h,
                     below = (double(j) + 0.5) * h, above = double(j + 1) * h;
        // On the grid a wave travels slower than its stream, and decays slower, than in the plane.
        const double slow = std::sin(k * h) / (k * h), mean = std::cos(k * h / 2);
        const double decay = std::exp(-viscosity_ * 4 * (1 - std::cos(k * h)) / (h * h) * t);
        const double a = slow * (t + (1 - std::cos(4 * t)) / 8), b = slow * std::sin(3 * t) / 6;
        const auto x = [&](double at) { return k * (at - a); };
        const auto y = [&](double at) { return k * (at - b); };
        return {1 + std::sin(4 * t) / 2 + decay * std::sin(x(right)) * std::cos(y(below)),
                std::cos(3 * t) / 2 - decay * std::cos(x(left)) * std::sin(y(above)),
                -2 * std::cos(4 * t) * left + 1.5 * std::sin(3 * t) * below +
                    mean * mean / 4 * decay * decay * (std::cos(2 * x(left)) + std::cos(2 * y(below)))};
    }
    vector solution(double t) const {
        vector y(3 * width_ * height_);
        each([&](PetscInt i, PetscInt j, PetscInt at) {
            const cell c = solution(t, i, j);
            y[at] = c.u, y[at + 1] = c.v, y[at + 2] = c.p;
        });
        return y;
    }
    /// The largest errors of velocity and pressure, over all processes.
    std::array<double, 2> errors(double t, const vector& y) const {
        const vector e = (y - solution(t)).cwiseAbs();
        std::array<double, 2> most{0, 0};
        for (Eigen::Index k = 0; k < e.size(); ++k) most[k % 3 == 2] = std::max(most[k % 3 == 2], e[k]);
        MPI_Allreduce(MPI_IN_PLACE, most.data(), 2, MPI_DOUBLE, MPI_MAX, processes_);
        return most;
    }

    void add_up(double* x, int k) const { stagecraft::petsc_add_up(processes_, x, k); }
    std::vector<int> index() const {
        std::vector<int> flags(static_cast<std::size_t>(3 * width_ * height_), 1);
        for (std::size_t k = 2; k < flags.size(); k += 3) flags[k] = 2;
        return flags;
    }
    /// One for velocities, zero for pressures.
    stagecraft::petsc_matrix mass() const {
        using stagecraft::petsc_check;
        const auto M = stagecraft::petsc_made<Mat>([&](Mat* A) { return DMCreateMatrix(grid_.get(), A); });
        each([&](PetscInt i, PetscInt j, PetscInt) {
            for (PetscInt c = 0; c < 2; ++c) {
                const MatStencil here{0, j, i, c};
                const double one = 1;
                petsc_check(MatSetValuesStencil(M.get(), 1, &here, 1, &here, &one, INSERT_VALUES));
            }
        });
        petsc_check(MatAssemblyBegin(M.get(), MAT_FINAL_ASSEMBLY));
        petsc_check(MatAssemblyEnd(M.get(), MAT_FINAL_ASSEMBLY));
        return stagecraft::petsc_matrix(M.get());
    }

    void operator()(double t, const vector& y, vector& f) const {
        with_neighbours(t, y, [&](const cell* z, PetscInt row, PetscInt, PetscInt, PetscInt at) {
            f[at] = momentum(z, 1, row, &cell::u, &cell::v);
            f[at + 1] = momentum(z, row, 1, &cell::v, &cell::u);
            f[at + 2] = (z[-1].u - z->u + z[-row].v - z->v) / step();
        });
    }
    stagecraft::petsc_matrix matrix() const {
        const auto J = stagecraft::petsc_made<Mat>([&](Mat* A) { return DMCreateMatrix(grid_.get(), A); });
        fill(0, solution(0), J.get());
        return stagecraft::petsc_matrix(J.get());
    }
    void jacobian(double t, const vector& y, stagecraft::petsc_matrix& J) const { fill(t, y, J.get()); }

  private:
    static constexpr double wave = 2 * std::numbers::pi;
    double step() const { return 1 / static_cast<double>(n_); }

    /// The momentum equation of the velocity U that points to cell z + along; W is the other one, across.
    double momentum(const cell* z, PetscInt along, PetscInt across, double cell::*U, double cell::*W) const {
        const double h = step();
        const auto at = [&](PetscInt place, double cell::*what) { return z[place].*what; };
        const double here = at(0, U), ahead = (here + at(along, U)) / 2, behind = (here + at(-along, U)) / 2;
        const double above = (here + at(across, U)) * (at(0, W) + at(along, W)) / 4,
                     below = (here + at(-across, U)) * (at(-across, W) + at(along - across, W)) / 4;
        const double around = at(along, U) + at(-along, U) + at(across, U) + at(-across, U);
        return (behind * behind - ahead * ahead + below - above + at(0, &cell::p) - at(along, &cell::p)) / h +
               viscosity_ * (around - 4 * here) / (h * h);
    }
    /// Its derivatives with respect to U here, ahead, behind, above and below, to the four W, and to p here and ahead.
    std::array<double, 11> derivatives(const cell* z, PetscInt along, PetscInt across, double cell::*U,
                                       double cell::*W) const {
        const double h = step(), diffusion = viscosity_ / (h * h);
        const auto at = [&](PetscInt place, double cell::*what) { return z[place].*what; };
        const double here = at(0, U), ahead = (here + at(along, U)) / (2 * h),
                     behind = (here + at(-along, U)) / (2 * h);
        const double U_above = (here + at(across, U)) / (4 * h), U_below = (here + at(-across, U)) / (4 * h);
        const double W_above = (at(0, W) + at(along, W)) / (4 * h),
                     W_below = (at(-across, W) + at(along - across, W)) / (4 * h);
        return {behind - ahead + W_below - W_above - 4 * diffusion,
                diffusion - ahead,
                diffusion + behind,
                diffusion - W_above,
                diffusion + W_below,
                -U_above,
                -U_above,
                U_below,
                U_below,
                1 / h,
                -1 / h};
    }
    void fill(double t, const vector& y, Mat J) const {
        using stagecraft::petsc_check;
        with_neighbours(t, y, [&](const cell* z, PetscInt row, PetscInt i, PetscInt j, PetscInt) {
            const auto put = [&](PetscInt c, PetscInt dx, PetscInt dy, const std::array<double, 11>& values) {
                const PetscInt o = 1 - c, m = i + dx, n = j + dy;  // one cell along
                const MatStencil here{0, j, i, c}, columns[] = {here,
                                                                {0, n, m, c},
                                                                {0, j - dy, i - dx, c},
                                                                {0, j + dx, i + dy, c},
                                                                {0, j - dx, i - dy, c},
                                                                {0, j, i, o},
                                                                {0, n, m, o},
                                                                {0, j - dx, i - dy, o},
                                                                {0, n - dx, m - dy, o},
                                                                {0, j, i, 2},
                                                                {0, n, m, 2}};
                petsc_check(MatSetValuesStencil(J, 1, &here, 11, columns, values.data(), INSERT_VALUES));
            };
            put(0, 1, 0, derivatives(z, 1, row, &cell::u, &cell::v));
            put(1, 0, 1, derivatives(z, row, 1, &cell::v, &cell::u));
            const MatStencil here{0, j, i, 2},
                sides[] = {{0, j, i - 1, 0}, {0, j, i, 0}, {0, j - 1, i, 1}, {0, j, i, 1}};
            const double h = step(), flow[] = {1 / h, -1 / h, 1 / h, -1 / h};
            petsc_check(MatSetValuesStencil(J, 1, &here, 4, sides, flow, INSERT_VALUES));
        });
        petsc_check(MatAssemblyBegin(J, MAT_FINAL_ASSEMBLY));
        petsc_check(MatAssemblyEnd(J, MAT_FINAL_ASSEMBLY));
    }
    /// Calls visit(z, row, i, j, place) for every cell of this process: z is the cell, z + 1 the one at its right, z + row the
    /// one above. Cells outside of the square have the values of the solution.
    template <class Visit>
    void with_neighbours(double t, const vector& y, Visit&& visit) const {
        using stagecraft::petsc_check;
        {
            const stagecraft::petsc_view view(state_.get(), y.data());
            petsc_check(DMGlobalToLocal(grid_.get(), state_.get(), INSERT_VALUES, around_.get()));
        }
        double* numbers = nullptr;
        petsc_check(VecGetArray(around_.get(), &numbers));
        const PetscInt row = width_ + 2;
        std::vector<cell> cells(static_cast<std::size_t>(row * (height_ + 2)));
        for (PetscInt j = y_ - 1; j <= y_ + height_; ++j)
            for (PetscInt i = x_ - 1; i <= x_ + width_; ++i) {
                const PetscInt k = (j - y_ + 1) * row + i - x_ + 1;
                const bool inside = i >= 0 && i < n_ && j >= 0 && j < n_;
                cells[static_cast<std::size_t>(k)] =
                    inside ? cell{numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]} : solution(t, i, j);
            }
        petsc_check(VecRestoreArray(around_.get(), &numbers));
        each([&](PetscInt i, PetscInt j, PetscInt at) {
            visit(cells.data() + (j - y_ + 1) * row + i - x_ + 1, row, i, j, at);
        });
    }
    template <class Visit>
    void each(Visit&& visit) const {
        PetscInt at = 0;
        for (PetscInt j = y_; j < y_ + height_; ++j)
            for (PetscInt i = x_; i < x_ + width_; ++i, at += 3) visit(i, j, at);
    }

    MPI_Comm processes_;
    PetscInt n_, x_ = 0, y_ = 0, width_ = 0, height_ = 0;
    double viscosity_;
    stagecraft::petsc_owned<DM> grid_;
    stagecraft::petsc_owned<Vec> state_, around_;
};

using counted_flow = petsc_counted<incompressible_flow>;

/// The preconditioner: PCFIELDSPLIT, an incomplete factorisation for the velocities (on each process its own part) and
/// multigrid for the pressure's Schur complement, in which their diagonal stands for them. What has been set before stays;
/// returns the options that were not.
/// (Where the stream crosses two cells in a step, Gauss-Seidel sweeps instead of the factorisation do not converge.)
inline std::vector<std::string> split_fields() {
    std::vector<std::string> added;
#ifdef PETSC_HAVE_HYPRE
    const char* const multigrid = "hypre";
#else
    const char* const multigrid = "gamg";
#endif
    for (const auto& [name, value] : {std::pair{"pc_type", "fieldsplit"},
                                      {"pc_fieldsplit_block_size", "3"},
                                      {"pc_fieldsplit_0_fields", "0,1"},
                                      {"pc_fieldsplit_1_fields", "2"},
                                      {"pc_fieldsplit_type", "schur"},
                                      {"pc_fieldsplit_schur_fact_type", "full"},
                                      {"pc_fieldsplit_schur_precondition", "selfp"},
                                      {"fieldsplit_0_ksp_type", "preonly"},
                                      {"fieldsplit_0_pc_type", "bjacobi"},
                                      {"fieldsplit_1_ksp_type", "preonly"},
                                      {"fieldsplit_1_pc_type", multigrid}}) {
        const std::string option = std::string("-stage_pc_") + name;
        PetscBool given = PETSC_FALSE;
        stagecraft::petsc_check(PetscOptionsHasName(nullptr, nullptr, option.c_str(), &given));
        if (given) continue;
        stagecraft::petsc_check(PetscOptionsSetValue(nullptr, option.c_str(), value));
        added.push_back(option);
    }
    return added;
}
