// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/linear_solve.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/preconditioner_life.hpp>
#include <stagecraft/linear/restarted_gmres.hpp>
#include <stagecraft/linear/shifted_sparse.hpp>

namespace stagecraft {

namespace detail {

/// An incomplete factorisation that knows how many entries it has.
struct counted_ilut : Eigen::IncompleteLUT<double> {
    Eigen::Index entries() const { return m_lu.nonZeros(); }
};

/// shift M - J and a preconditioner for it: where J is sparse an incomplete factorisation, which may be that of an
/// earlier shift and J (preconditioner_life.hpp), else J.precondition(shift, x).
class shifted_operator {
  public:
    using vector = Eigen::VectorXd;
    using in = Eigen::Ref<const vector>;
    using out = Eigen::Ref<vector>;

    /// False if the matrix is not finite, or its factorisation fails.
    template <class Mass, class Matrix>
    bool set(const Mass& mass, const Matrix& J, double shift) {
        add_mass_ = [&mass](double factor, const in& x, out r) {
            add_mass_times(mass, factor, x.data(), r.data(), static_cast<int>(x.size()));
        };
        if constexpr (requires(const double* x, double* r) { J.add_times(1.0, x, r); }) {
            multiply_ = [this, &J, shift](const in& x, out r) {
                r.setZero();
                add_mass(shift, x, r);
                J.add_times(-1.0, x.data(), r.data());
            };
            precondition_ = [&J, shift](const in& x, out r) {
                r = x;
                J.precondition(shift, r.data());
            };
            fresh_ = true;
            return true;
        } else {
            return factor(mass, J, shift);
        }
    }
    void multiply(const in& x, out r) const { multiply_(x, r); }
    void precondition(const in& x, out r) const { precondition_(x, r); }
    /// r := r + factor M x.
    void add_mass(double factor, const in& x, out r) const { add_mass_(factor, x, r); }
    /// Solves by iterate(), `applications` of the preconditioner an iteration; once more with a new factorisation where one
    /// of another matrix has failed.
    template <class Iterate>
    linear_solve solve(int applications, Iterate&& iterate) {
        linear_solve done = iterate();
        if (done.failed() && !fresh_ && factor()) {
            const int wasted = done.iterations;
            done = iterate();
            done.iterations += wasted;
        }
        if (done.failed())
            life_.failed();
        else
            life_.used(applications * done.iterations);
        if (done.end == linear_end::unconverged && zero_diagonal_) done.end = linear_end::zero_diagonal;
        return done;
    }
    /// Factorisations that have been made.
    long setups() const { return setups_; }

  private:
    template <class Mass>
    bool factor(const Mass& mass, const Eigen::SparseMatrix<double>& J, double shift) {
        if (!matrix_.fill(mass, J, shift)) {
            matrix_.adopt(mass, J);
            matrix_.fill(mass, J, shift);
        }
        if (!matrix_.finite()) return false;
        multiply_ = [this](const in& x, out r) { r.noalias() = matrix_.matrix() * x; };
        precondition_ = [this](const in& x, out r) { r = factors_.solve(x); };
        shift_ = shift;
        fresh_ = !life_.serves(shift);
        return !fresh_ || factor();
    }
    bool factor() {
        factors_.setDroptol(1e-2);
        factors_.setFillfactor(3);
        factors_.compute(matrix_.matrix());
        ++setups_;
        fresh_ = true;
        zero_diagonal_ = (matrix_.matrix().diagonal().array() == 0).any();
        life_.made(shift_, setup_cost());
        return factors_.info() == Eigen::Success;
    }
    /// Of a factorisation, in iterations of a real system: nanoseconds as measured for ILUT with 1 to 10 entries a row.
    double setup_cost() const {
        const double kept = static_cast<double>(factors_.entries()),
                     given = static_cast<double>(matrix_.matrix().nonZeros()),
                     rows = static_cast<double>(matrix_.matrix().rows());
        return (80 * given + 50 * kept) / (0.7 * given + 1.5 * kept + 11 * rows);
    }

    shifted_sparse<double> matrix_;
    counted_ilut factors_;
    preconditioner_life life_;
    double shift_ = 0;
    bool fresh_ = true, zero_diagonal_ = false;  // the preconditioner is that of this matrix
    long setups_ = 0;
    std::function<void(double, const in&, out)> add_mass_;
    std::function<void(const in&, out)> multiply_, precondition_;
};

}  // namespace detail

/// The linear systems of a step by restarted GMRES, for large problems on one machine: to a hundredth of the residual,
/// preconditioned from the right, in memory that is a multiple of n. A complex pair is solved as a real system of twice
/// the size with PRESB (Axelsson-Neytcheva), two applications of one real preconditioner, for the sum of the real and
/// imaginary parts of its shift. The preconditioner is an incomplete LU factorisation of shift M - J for a problem with
/// sparsity(); it outlives its Jacobian and its step while it serves (preconditioner_life.hpp). For a problem with matrix()
/// it is that object's: with add_times(factor, x, r), which adds factor J x to r, and precondition(shift, x), which
/// replaces x by about (shift M - J)^-1 x, on n contiguous numbers; no matrix need then ever be formed. Used as linear/klu.hpp is:
///
///     using linear_solver = stagecraft::krylov_blocks;
///
/// Inexact solves are Newton's business: what they leave shows in its contraction, and its last solves are told which
/// part of their right-hand sides they may leave (inexact_newton_monitor). A solve that has not come so far after 100
/// iterations, and with a new factorisation, has failed: its solution is NaN, the step is refused, and where no shorter
/// one helps the run ends with status::linear_solver_failed. Zeros on the diagonal of shift M - J, as constraints have
/// them (saddle points), make the incomplete factorisation useless: take a direct solver (linear/klu.hpp,
/// linear/sparse_lu.hpp), or a matrix() with a preconditioner of your own.
struct krylov_blocks {
    class real {
      public:
        explicit real(int n) : n_(n), system_(std::make_unique<detail::shifted_operator>()) {}
        template <class Mass, class Matrix>
        bool factor_shifted(const Mass& mass, const Matrix& J, double shift) {
            return n_ == 0 || system_->set(mass, J, shift);
        }
        void solve(double* x) { solve_leaving(0, x); }
        static constexpr double usual_part() { return bound; }
        void solve_leaving(double part, double* x) {
            last_ = {};
            if (n_ == 0) return;
            Eigen::Map<Eigen::VectorXd> map(x, n_);
            bool again = false;
            last_ = system_->solve(1, [&] {
                if (std::exchange(again, true)) map = gmres_.right_hand_side();
                return gmres_.solve([&](const auto& in, auto&& out) { system_->multiply(in, out); },
                                    [&](const auto& in, auto&& out) { system_->precondition(in, out); }, map,
                                    std::max(bound, part), most);
            });
        }
        const linear_solve& last_solve() const { return last_; }
        /// Incomplete factorisations that have been made.
        long setups() const { return system_->setups(); }

      private:
        int n_;
        std::unique_ptr<detail::shifted_operator> system_;  // its functions refer to it
        detail::restarted_gmres<double> gmres_;
        linear_solve last_;
    };

    class complex {
      public:
        explicit complex(int n)
            : n_(n), system_(std::make_unique<detail::shifted_operator>()), h_(n), w_(n), both_(2 * n) {}
        template <class Mass, class Matrix>
        bool factor_shifted(const Mass& mass, const Matrix& J, double re, double im) {
            beta_ = std::abs(im);
            sign_ = im < 0 ? -1 : 1;  // the conjugate system has the same real form
            return n_ == 0 || system_->set(mass, J, re + beta_);
        }
        void solve(double* x, double* y) { solve_leaving(0, x, y); }
        static constexpr double usual_part() { return bound; }
        void solve_leaving(double part, double* x, double* y) {
            last_ = {};
            if (n_ == 0) return;
            Eigen::Map<Eigen::VectorXd> u(x, n_), v(y, n_);
            last_ = system_->solve(2, [&] {
                both_ << u, sign_ * v;
                return gmres_.solve([&](const auto& in, auto&& out) { multiply(in, out); },
                                    [&](const auto& in, auto&& out) { precondition(in, out); }, both_,
                                    std::max(bound, part), most);
            });
            u = both_.head(n_);
            v = sign_ * both_.tail(n_);
        }
        const linear_solve& last_solve() const { return last_; }
        long setups() const { return system_->setups(); }

      private:
        /// With P = (re + beta) M - J and B = beta M: [A -B; B A] with A = P - B.
        template <class In, class Out>
        void multiply(const In& in, Out&& out) {
            const auto u = in.head(n_), v = in.tail(n_);
            system_->multiply(u, out.head(n_));
            system_->multiply(v, out.tail(n_));
            w_ = u + v;
            system_->add_mass(-beta_, w_, out.head(n_));
            w_ = u - v;
            system_->add_mass(beta_, w_, out.tail(n_));
        }
        /// h := P^-1 (r1 + r2), y := P^-1 (r2 - B h), x := h - y.
        template <class In, class Out>
        void precondition(const In& in, Out&& out) {
            w_ = in.head(n_) + in.tail(n_);
            system_->precondition(w_, h_);
            w_ = in.tail(n_);
            system_->add_mass(-beta_, h_, w_);
            system_->precondition(w_, out.tail(n_));
            out.head(n_) = h_ - out.tail(n_);
        }

        int n_;
        double beta_ = 0, sign_ = 1;
        std::unique_ptr<detail::shifted_operator> system_;
        detail::restarted_gmres<double> gmres_;
        linear_solve last_;
        Eigen::VectorXd h_, w_, both_;
    };

    /// Per stage, in nanoseconds: half a factorisation, and about ten products and solves an iteration.
    static block_work<double> work(int n) { return {500.0 * n, 600.0 * n}; }

  private:
    static constexpr double bound = 1e-2;
    static constexpr int most = 100;
};

}  // namespace stagecraft
