// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <petscmat.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

// What stagecraft needs of PETSc: owned handles, views of memory, a matrix. linear/petsc.hpp has the solvers.

namespace stagecraft {

#ifdef PETSC_USE_COMPLEX
static_assert(!sizeof(PetscScalar), "stagecraft/linear/petsc_matrix.hpp needs PETSc with real scalars");
#endif
static_assert(std::is_same_v<PetscReal, double>,
              "stagecraft/linear/petsc_matrix.hpp needs PETSc in double precision");

/// Throws std::runtime_error where PETSc reports an error. PETSc has printed by then what it was.
inline void petsc_check(PetscErrorCode code) {
    if (code != 0) throw std::runtime_error("PETSc reports error " + std::to_string(static_cast<int>(code)));
}

/// What a callback of PETSc's returns: exceptions do not pass through C.
template <class F>
PetscErrorCode petsc_code(F&& f) {
    try {
        f();
    } catch (...) {
        return PETSC_ERR_LIB;
    }
    return 0;
}

/// Replaces k numbers by their sums over the processes of a communicator.
inline void petsc_add_up(MPI_Comm processes, double* x, int k) {
    if (MPI_Allreduce(MPI_IN_PLACE, x, k, MPI_DOUBLE, MPI_SUM, processes) != MPI_SUCCESS)
        throw std::runtime_error("MPI_Allreduce failed");
}

struct petsc_release {
    template <class T>
    void operator()(T* handle) const {
        auto object = reinterpret_cast<PetscObject>(handle);
        PetscObjectDestroy(&object);
    }
};
/// Owns one reference to an object of PETSc's: petsc_owned<Mat>.
template <class Handle>
using petsc_owned = std::unique_ptr<std::remove_pointer_t<Handle>, petsc_release>;

/// petsc_made<Vec>([&](Vec* v) { return VecDuplicate(x, v); }): what a function of PETSc's has made.
template <class Handle, class Make>
petsc_owned<Handle> petsc_made(Make make) {
    Handle handle = nullptr;
    petsc_check(make(&handle));
    return petsc_owned<Handle>(handle);
}

/// The memory of n local numbers as a vector of PETSc's, as long as this lives.
class petsc_view {
  public:
    petsc_view(Vec v, const double* x) : v_(v) { petsc_check(VecPlaceArray(v, x)); }
    ~petsc_view() { VecResetArray(v_); }
    petsc_view(const petsc_view&) = delete;
    petsc_view& operator=(const petsc_view&) = delete;

  private:
    Vec v_;
};

/// What linear systems have cost: applications of the preconditioner (cycles), hierarchies that have been set up,
/// solves and Krylov iterations, real ones and pairs.
struct petsc_counts {
    long cycles = 0, setups = 0;
    long real_solves = 0, real_iterations = 0, pair_solves = 0, pair_iterations = 0;
    long most_real = 0, most_pair = 0;  ///< iterations of one solve
};

/// A handle of a matrix of PETSc's; copies refer to the same one. rows() and cols() are local sizes.
class petsc_matrix {
  public:
    /// Refers to A as long as this lives.
    explicit petsc_matrix(Mat A) : counts_(std::make_shared<petsc_counts>()) {
        petsc_check(PetscObjectReference(reinterpret_cast<PetscObject>(A)));
        A_ = std::shared_ptr<std::remove_pointer_t<Mat>>(A, petsc_release{});
        Vec x = nullptr, y = nullptr;
        petsc_check(MatCreateVecs(A, &x, &y));
        x_ = std::shared_ptr<std::remove_pointer_t<Vec>>(x, petsc_release{});
        y_ = std::shared_ptr<std::remove_pointer_t<Vec>>(y, petsc_release{});
    }
    Mat get() const { return A_.get(); }
    PetscInt rows() const { return local(0); }
    PetscInt cols() const { return local(1); }
    /// Adds `factor` A x to r (local parts): what mass() asks for.
    void add_times(double factor, const double* x, double* r) const {
        const petsc_view in(x_.get(), x);
        petsc_check(MatMult(A_.get(), x_.get(), y_.get()));
        const double* product = nullptr;
        petsc_check(VecGetArrayRead(y_.get(), &product));
        for (PetscInt i = 0, n = rows(); i < n; ++i) r[i] += factor * product[i];
        petsc_check(VecRestoreArrayRead(y_.get(), &product));
    }
    /// Of all systems with this Jacobian.
    petsc_counts& counts() const { return *counts_; }

  private:
    PetscInt local(int which) const {
        PetscInt size[2];
        petsc_check(MatGetLocalSize(A_.get(), &size[0], &size[1]));
        return size[which];
    }
    std::shared_ptr<std::remove_pointer_t<Mat>> A_;
    std::shared_ptr<std::remove_pointer_t<Vec>> x_, y_;
    std::shared_ptr<petsc_counts> counts_;
};

}  // namespace stagecraft
