// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <petscksp.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/petsc_iteration.hpp>
#include <stagecraft/linear/petsc_matrix.hpp>
#include <stagecraft/linear/petsc_multigrid.hpp>
#include <stagecraft/linear/preconditioner_life.hpp>

// Distributed linear systems by PETSc (real scalars; Debian: libpetsc-real-dev). A problem that uses them has
//
//     using linear_solver = stagecraft::petsc_blocks;
//     stagecraft::petsc_matrix matrix() const;                         // for its Jacobian, with a place for every entry
//     void jacobian(double t, const Vector& y, stagecraft::petsc_matrix& J) const;   // fills J.get()
//     void add_up(double* x, int k) const { stagecraft::petsc_add_up(communicator, x, k); }
//
// and optionally mass(), a petsc_matrix as well. States are Eigen vectors of the local size of these matrices, whose
// memory PETSc's vectors use. PETSc must be initialised before and finalised after all of this lives.

namespace stagecraft {

namespace detail {

inline Mat petsc_mass(const identity_mass&) { return nullptr; }
inline Mat petsc_mass(const mass_by_products<petsc_matrix>& m) { return m.get().get(); }

/// The matrix shift M - J and a preconditioner for it, one hierarchy (options prefix stage_pc_).
class petsc_shifted {
  public:
    /// False if the matrix is not finite or the preconditioner cannot be made, on all processes.
    bool set(Mat mass, const petsc_matrix& J, double shift) {
        if (!matrix_) make(mass, J);
        if (mass) {
            petsc_check(MatZeroEntries(matrix_.get()));
            petsc_check(MatAXPY(matrix_.get(), -1, J.get(), SUBSET_NONZERO_PATTERN));
            petsc_check(MatAXPY(matrix_.get(), shift, mass, SUBSET_NONZERO_PATTERN));
        } else {
            petsc_check(MatCopy(J.get(), matrix_.get(), SAME_NONZERO_PATTERN));
            petsc_check(MatScale(matrix_.get(), -1));
            petsc_check(MatShift(matrix_.get(), shift));
        }
        PetscReal size = 0;
        petsc_check(MatNorm(matrix_.get(), NORM_FROBENIUS, &size));
        if (!std::isfinite(size)) return false;
        shift_ = shift;
        kept_ = life_.serves(shift);
        petsc_check(PCSetReusePreconditioner(pc_.get(), kept_ ? PETSC_TRUE : PETSC_FALSE));
        petsc_check(PCSetOperators(pc_.get(), matrix_.get(), matrix_.get()));
        return kept_ || set_up();
    }
    /// Makes a hierarchy of the matrix, on all processes, where there is one of another; false if it cannot be made or there
    /// is none.
    bool renew() {
        if (!kept_) return false;
        petsc_check(PCSetReusePreconditioner(pc_.get(), PETSC_FALSE));
        petsc_check(PCSetOperators(pc_.get(), matrix_.get(), matrix_.get()));
        return set_up();
    }
    Mat matrix() const { return matrix_.get(); }
    PC pc() const { return pc_.get(); }
    petsc_counts& counts() const { return *counts_; }
    petsc_owned<Vec> vector() const {
        return petsc_made<Vec>([&](Vec* v) { return MatCreateVecs(matrix(), v, nullptr); });
    }
    /// A solve has taken so many cycles, or has failed.
    void used(long cycles, bool failed) {
        if (failed)
            life_.failed();
        else
            life_.used(static_cast<double>(cycles));
    }
    /// out := one cycle on in.
    void cycle(Vec in, Vec out) const {
        ++counts_->cycles;
        petsc_check(PCApply(pc_.get(), in, out));
    }

  private:
    bool set_up() {
        kept_ = false;
        ++counts_->setups;
        life_.made(shift_, setup_cost);
        petsc_check(PCSetUp(pc_.get()));
        PCFailedReason failed = PC_NOERROR;
        petsc_check(PCGetFailedReason(pc_.get(), &failed));
        return failed == PC_NOERROR;
    }
    void make(Mat mass, const petsc_matrix& J) {
        counts_ = &J.counts();
        matrix_ = petsc_made<Mat>([&](Mat* A) { return MatDuplicate(J.get(), MAT_COPY_VALUES, A); });
        if (mass) petsc_check(MatAXPY(matrix_.get(), 1, mass, DIFFERENT_NONZERO_PATTERN));
        MPI_Comm processes = MPI_COMM_NULL;
        petsc_check(PetscObjectGetComm(reinterpret_cast<PetscObject>(J.get()), &processes));
        pc_ = petsc_made<PC>([&](PC* pc) { return PCCreate(processes, pc); });
        petsc_multigrid(pc_.get());
        petsc_check(PCSetOperators(pc_.get(), matrix_.get(), matrix_.get()));
        petsc_check(PCSetFromOptions(pc_.get()));
    }

    static constexpr double setup_cost = 5;  // in cycles
    petsc_owned<Mat> matrix_;
    petsc_owned<PC> pc_;
    petsc_counts* counts_ = nullptr;
    preconditioner_life life_;
    double shift_ = 0;
    bool kept_ = false;  // the hierarchy is that of another matrix
};

/// (re - i |im|) M - J as real matrix of twice the size, preconditioned by cycles of real hierarchies.
class petsc_pair {
  public:
    petsc_pair() = default;
    petsc_pair(const petsc_pair&) = delete;
    petsc_pair& operator=(const petsc_pair&) = delete;

    bool set(Mat mass, const petsc_matrix& J, double re, double im) {
        if (!iteration_.made()) choose();
        mass_ = mass;
        flip_ = im < 0;
        beta_ = std::abs(im);
        const double second = re + beta_ * beta_ / re;
        if (!(presb_ ? first_.set(mass, J, re + beta_)
                     : first_.set(mass, J, re) && second_.set(mass, J, second)))
            return false;
        shift_ = presb_ ? re + beta_ : re;
        re_ = re;
        if (!iteration_.made()) make(J);
        iteration_.set_matrix(operator_.get());
        return true;
    }
    double usual_part() const { return iteration_.usual_part(); }
    linear_solve solve(double* x, double* y, double part) {
        const auto n = static_cast<std::size_t>(n_);
        double* both = x;
        if (y != x + n) {  // the steppers hand them over side by side
            room_ = std::make_unique<double[]>(2 * n);
            std::memcpy(room_.get(), x, sizeof(double) * n);
            std::memcpy(room_.get() + n, y, sizeof(double) * n);
            both = room_.get();
        }
        const double sign = flip_ ? -1 : 1;  // the conjugate system
        for (std::size_t i = n; i < 2 * n; ++i) both[i] *= sign;
        linear_solve done = iteration_.solve(both, part);
        const auto renew = [&] {
            const bool first = first_.renew(), second = !presb_ && second_.renew();
            return first || second;
        };
        if (done.failed() && renew()) {
            const int wasted = done.iterations;
            iteration_.give_back(both);
            done = iteration_.solve(both, part);
            done.iterations += wasted;
        }
        for (std::size_t i = n; i < 2 * n; ++i) both[i] *= sign;
        if (both != x) {
            std::memcpy(x, both, sizeof(double) * n);
            std::memcpy(y, both + n, sizeof(double) * n);
        }
        const long iterations = done.iterations;
        first_.used((presb_ ? 2 : 1) * iterations, done.failed());
        if (!presb_) second_.used(iterations, done.failed());
        petsc_counts& counts = first_.counts();
        ++counts.pair_solves;
        counts.pair_iterations += iterations;
        if (iterations > counts.most_pair) counts.most_pair = iterations;
        return done;
    }

    /// With P = shift M - J and B = beta M: the product with [A -B; B A], A = re M - J = P - (shift - re) M.
    void multiply(Vec in, Vec out) {
        with_halves(in, out, [&] {
            petsc_check(MatMult(first_.matrix(), u_.get(), p_.get()));
            petsc_check(MatMult(first_.matrix(), v_.get(), q_.get()));
            const double less = shift_ - re_;
            petsc_check(VecSet(w_.get(), 0));
            petsc_check(VecAXPBYPCZ(w_.get(), less, beta_, 0, u_.get(), v_.get()));
            add_mass(-1, w_.get(), p_.get());
            petsc_check(VecAXPBYPCZ(w_.get(), beta_, -less, 0, u_.get(), v_.get()));
            add_mass(1, w_.get(), q_.get());
        });
    }
    /// PRESB (Axelsson-Neytcheva): h := (A+B)^-1 (r1 + r2), y := (A+B)^-1 (r2 - B h), x := h - y. Or
    /// block-triangular (Southworth et al.): x := A^-1 r1, y := (A + B A^-1 B)^-1 (r2 - B x) with the middle factor
    /// replaced by (re + beta^2/re) M - J.
    void precondition(Vec in, Vec out) {
        with_halves(in, out, [&] {
            if (presb_)
                petsc_check(VecWAXPY(w_.get(), 1, u_.get(), v_.get()));
            else
                petsc_check(VecCopy(u_.get(), w_.get()));
            first_.cycle(w_.get(), p_.get());
            petsc_check(VecCopy(v_.get(), w_.get()));
            add_mass(-beta_, p_.get(), w_.get());
            (presb_ ? first_ : second_).cycle(w_.get(), q_.get());
            if (presb_) petsc_check(VecAXPY(p_.get(), -1, q_.get()));
        });
    }

  private:
    /// -stage_pair_scheme presb | triangular
    void choose() {
        char scheme[32] = "presb";
        petsc_check(PetscOptionsGetString(nullptr, "stage_pair_", "-scheme", scheme, sizeof scheme, nullptr));
        presb_ = std::string(scheme) == "presb";
        if (!presb_ && std::string(scheme) != "triangular")
            throw std::invalid_argument("-stage_pair_scheme must be presb or triangular");
    }
    void make(const petsc_matrix& J) {
        n_ = J.rows();
        MPI_Comm processes = MPI_COMM_NULL;
        petsc_check(PetscObjectGetComm(reinterpret_cast<PetscObject>(J.get()), &processes));
        operator_ = petsc_made<Mat>([&](Mat* A) {
            return MatCreateShell(processes, 2 * n_, 2 * n_, PETSC_DETERMINE, PETSC_DETERMINE, this, A);
        });
        using function = PetscErrorCode (*)(Mat, Vec, Vec);
        const function product = [](Mat A, Vec in, Vec out) -> PetscErrorCode {
            void* context = nullptr;
            if (const PetscErrorCode code = MatShellGetContext(A, &context)) return code;
            return petsc_code([&] { static_cast<petsc_pair*>(context)->multiply(in, out); });
        };
        petsc_check(MatShellSetOperation(operator_.get(), MATOP_MULT, reinterpret_cast<void (*)()>(product)));
        iteration_.make("stage_pair_", operator_.get(), this);
        for (auto* v : {&u_, &v_, &p_, &q_, &w_, &z_}) *v = first_.vector();
    }
    /// y := y + factor M x.
    void add_mass(double factor, Vec x, Vec y) {
        if (mass_) {
            petsc_check(MatMult(mass_, x, z_.get()));
            x = z_.get();
        }
        petsc_check(VecAXPY(y, factor, x));
    }
    /// Does something with the halves u, v of one vector and p, q of another.
    template <class F>
    void with_halves(Vec in, Vec out, F&& f) {
        const double* from = nullptr;
        double* to = nullptr;
        petsc_check(VecGetArrayRead(in, &from));
        petsc_check(VecGetArrayWrite(out, &to));
        {
            const petsc_view u(u_.get(), from), v(v_.get(), from + n_), p(p_.get(), to), q(q_.get(), to + n_);
            f();
        }
        petsc_check(VecRestoreArrayWrite(out, &to));
        petsc_check(VecRestoreArrayRead(in, &from));
    }

    PetscInt n_ = 0;
    Mat mass_ = nullptr;
    double re_ = 0, beta_ = 0, shift_ = 0;
    bool flip_ = false, presb_ = true;
    petsc_shifted first_, second_;
    petsc_owned<Mat> operator_;
    petsc_owned<Vec> u_, v_, p_, q_, w_, z_;
    petsc_iteration iteration_;
    std::unique_ptr<double[]> room_;
};

/// shift M - J, each iteration one cycle.
class petsc_single {
  public:
    petsc_single() = default;
    petsc_single(const petsc_single&) = delete;
    petsc_single& operator=(const petsc_single&) = delete;

    bool set(Mat mass, const petsc_matrix& J, double shift) {
        if (!shifted_.set(mass, J, shift)) return false;
        if (!iteration_.made()) iteration_.make("stage_real_", shifted_.matrix(), this);
        iteration_.set_matrix(shifted_.matrix());
        return true;
    }
    double usual_part() const { return iteration_.usual_part(); }
    linear_solve solve(double* x, double part) {
        linear_solve done = iteration_.solve(x, part);
        if (done.failed() && shifted_.renew()) {
            const int wasted = done.iterations;
            iteration_.give_back(x);
            done = iteration_.solve(x, part);
            done.iterations += wasted;
        }
        const long iterations = done.iterations;
        shifted_.used(iterations, done.failed());
        petsc_counts& counts = shifted_.counts();
        ++counts.real_solves;
        counts.real_iterations += iterations;
        if (iterations > counts.most_real) counts.most_real = iterations;
        return done;
    }
    void precondition(Vec in, Vec out) { shifted_.cycle(in, out); }

  private:
    petsc_shifted shifted_;
    petsc_iteration iteration_;
};

}  // namespace detail

/// The linear systems of a step on distributed matrices (petsc_matrix), by flexible GMRES to a hundredth of the
/// residual, preconditioned from the right. Real systems take one cycle of the preconditioner (algebraic multigrid by
/// default: PCGAMG with Gauss-Seidel smoothing) for shift M - J an iteration; a complex pair two cycles of one real
/// hierarchy, for the sum of the real and imaginary part of its shift. J needs a place for every diagonal entry, and M, J the same layout.
///
/// Everything can be set from PETSc's options: -stage_real_ and -stage_pair_ are the prefixes of the iterations
/// (-stage_real_ksp_rtol 1e-3), -stage_pc_ that of the preconditioner (-stage_pc_pc_type hypre), and
/// -stage_pair_scheme triangular takes another preconditioner of pairs, with two hierarchies.
///
/// A hierarchy outlives the Jacobian and the step it was made for while it serves, a setup counted as five cycles
/// (preconditioner_life.hpp).
///
/// Inexact solves are Newton's business: what they leave shows in its contraction, and its last solves are told which
/// part of their right-hand sides they may leave (inexact_newton_monitor). A solve that has not come so far after the
/// iterations that the options allow, 60 as a rule, and with a new hierarchy, has failed: the step is refused, and where no
/// shorter one helps the run ends with status::linear_solver_failed. An error that PETSc reports is a
/// std::runtime_error on the process where it does.
struct petsc_blocks {
    class real {
      public:
        explicit real(int) : system_(std::make_unique<detail::petsc_single>()) {}
        template <class Mass>
        bool factor_shifted(const Mass& mass, const petsc_matrix& J, double shift) {
            return system_->set(detail::petsc_mass(mass), J, shift);
        }
        void solve(double* x) { last_ = system_->solve(x, 0); }
        double usual_part() const { return system_->usual_part(); }
        void solve_leaving(double part, double* x) { last_ = system_->solve(x, part); }
        const linear_solve& last_solve() const { return last_; }

      private:
        linear_solve last_;
        std::unique_ptr<detail::petsc_single> system_;  // PETSc's shells refer to it
    };
    class complex {
      public:
        explicit complex(int) : system_(std::make_unique<detail::petsc_pair>()) {}
        template <class Mass>
        bool factor_shifted(const Mass& mass, const petsc_matrix& J, double re, double im) {
            return system_->set(detail::petsc_mass(mass), J, re, im);
        }
        void solve(double* x, double* y) { last_ = system_->solve(x, y, 0); }
        double usual_part() const { return system_->usual_part(); }
        void solve_leaving(double part, double* x, double* y) { last_ = system_->solve(x, y, part); }
        const linear_solve& last_solve() const { return last_; }

      private:
        linear_solve last_;
        std::unique_ptr<detail::petsc_pair> system_;
    };

    /// Per stage, in nanoseconds: half a hierarchy, and a little over two cycles an iteration, of some 200
    /// operations per unknown each.
    static block_work<double> work(int n) { return {500.0 * n, 440.0 * n}; }
};

}  // namespace stagecraft
