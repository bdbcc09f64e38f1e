// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <complex>
#include <memory>
#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/shifted_sparse.hpp>
#include <stagecraft/linear/sparse_lu.hpp>

namespace stagecraft {

namespace detail {

/// By the entries of the factors (zeros if they are not known): a solve passes over each, and in an
/// elimination each meets about as many of them as there are in a column.
template <class Scalar>
block_work<Scalar> work_of_factors(const Scalar& entries, Eigen::Index n) {
    return {n > 0 ? Scalar(entries * entries / Scalar(static_cast<double>(n))) : Scalar(0), 4 * entries};
}

}  // namespace detail

/// The linear solvers for shift M - J with J an Eigen::SparseMatrix, on any sparse direct solvers with
/// Eigen's interface: analyzePattern, factorize, solve, info. sparse_lu by default; where SuiteSparse is
/// installed linear/klu.hpp and linear/umfpack.hpp have KLU and UMFPACK. The pattern is analysed once per
/// pattern of J, so J should keep explicit zeros; a matrix of the same pattern costs its factorisation only.
template <class Scalar, class RealSolver = sparse_lu<Scalar>,
          class ComplexSolver = sparse_lu<std::complex<Scalar>>>
struct sparse_blocks {
    /// For a real shift.
    class real {
      public:
        explicit real(int n) : x_(n) {}
        /// Factors shift M - J; false if it is singular or not finite.
        template <class Mass>
        bool factor_shifted(const Mass& mass, const Eigen::SparseMatrix<Scalar>& J, const Scalar& shift) {
            return refactor(*solver_, a_, mass, J, shift) && count(*solver_, entries_);
        }
        /// x := (shift M - J)^-1 x, n contiguous numbers.
        void solve(Scalar* x) {
            if (x_.size() == 0) return;
            Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>> map(x, x_.size());
            x_ = map;
            map = solver_->solve(x_);
        }

        /// What the systems of a step cost, as is known since one was factored; zeros before.
        step_work<Scalar> work() const { return {{}, detail::work_of_factors(entries_, x_.size())}; }

      private:
        std::unique_ptr<RealSolver> solver_ = std::make_unique<RealSolver>();  // the solvers cannot be moved
        shifted_sparse<Scalar> a_;
        Eigen::Matrix<Scalar, Eigen::Dynamic, 1> x_;
        Scalar entries_{0};  // of the factors, if the solver counts them
    };

    /// For a complex shift re + i im; solve(x, y) takes real and imaginary parts.
    class complex {
        using number = std::complex<Scalar>;

      public:
        explicit complex(int n) : z_(n), w_(n) {}
        /// Factors (re + i im) M - J; false if it is singular or not finite.
        template <class Mass>
        bool factor_shifted(const Mass& mass, const Eigen::SparseMatrix<Scalar>& J, const Scalar& re,
                            const Scalar& im) {
            return refactor(*solver_, a_, mass, J, number(re, im)) && count(*solver_, entries_);
        }
        void solve(Scalar* x, Scalar* y) {
            const Eigen::Index n = z_.size();
            if (n == 0) return;
            for (Eigen::Index i = 0; i < n; ++i) z_[i] = number(x[i], y[i]);
            w_ = solver_->solve(z_);
            for (Eigen::Index i = 0; i < n; ++i) x[i] = w_[i].real(), y[i] = w_[i].imag();
        }

        step_work<Scalar> work() const { return {{}, detail::work_of_factors(entries_, z_.size())}; }

      private:
        std::unique_ptr<ComplexSolver> solver_ = std::make_unique<ComplexSolver>();
        shifted_sparse<number> a_;
        Eigen::Matrix<number, Eigen::Dynamic, 1> z_, w_;
        Scalar entries_{0};
    };

  private:
    template <class Solver>
    static bool count(const Solver& solver, Scalar& entries) {
        if constexpr (requires { solver.entries_of_factors(); })
            entries = Scalar(solver.entries_of_factors());
        else if constexpr (requires { solver.nnzL() + solver.nnzU(); })
            entries = Scalar(static_cast<double>(solver.nnzL()) + static_cast<double>(solver.nnzU()));
        return true;
    }
    template <class Solver, class T, class Mass>
    static bool refactor(Solver& solver, shifted_sparse<T>& a, const Mass& mass,
                         const Eigen::SparseMatrix<Scalar>& J, const T& shift) {
        if (J.rows() == 0) return true;
        if (!a.fill(mass, J, shift)) {
            a.adopt(mass, J);
            a.fill(mass, J, shift);
            solver.analyzePattern(a.matrix());
        }
        if (!a.finite()) return false;
        solver.factorize(a.matrix());
        return solver.info() == Eigen::Success;
    }
};

/// The fill is not known before the first factorisation: two-dimensional problems cost more than this says.
template <class Number, int Options, class Index>
struct work_of<Eigen::SparseMatrix<Number, Options, Index>> {
    template <class Scalar>
    static block_work<Scalar> estimate(const Eigen::SparseMatrix<Number, Options, Index>& J) {
        const Scalar n = Scalar(J.rows()), entries = Scalar(J.nonZeros());
        return {8 * n + 70 * entries, 30 * n + 15 * entries};
    }
};

template <class Scalar, int Options, class Index>
struct default_blocks<Eigen::SparseMatrix<Scalar, Options, Index>> {
    using type = sparse_blocks<Scalar>;
};

}  // namespace stagecraft
