// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <vector>

#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/linear_solve.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/preconditioner_life.hpp>
#include <stagecraft/linear/restarted_gmres.hpp>
#include <stagecraft/linear/shifted_sparse.hpp>
#include <stagecraft/linear/sparse_blocks.hpp>

namespace stagecraft {

namespace detail {

/// The matrix sigma M - J, and factors of it or of an earlier one.
template <class Solver>
class kept_factors {
  public:
    /// Takes a matrix; false if it is not finite, or singular where it is factored. With `keep` the factors stay those of
    /// the matrix that was factored last, if the pattern is the same.
    template <class Mass>
    bool set(const Mass& mass, const Eigen::SparseMatrix<double>& J, double sigma, bool keep) {
        exact_ = !keep;
        if (!matrix_.fill(mass, J, sigma)) {
            matrix_.adopt(mass, J);
            matrix_.fill(mass, J, sigma);
            solver_.analyzePattern(matrix_.matrix());
            exact_ = true;
        }
        if (!matrix_.finite()) return false;
        sigma_ = sigma;
        return !exact_ || factor();
    }
    /// Makes factors of the matrix; false if it is singular.
    bool factor() {
        exact_ = true;
        ++setups_;
        solver_.factorize(matrix_.matrix());
        return solver_.info() == Eigen::Success;
    }
    /// The factors are those of the matrix.
    bool exact() const { return exact_; }
    double sigma() const { return sigma_; }
    const Eigen::SparseMatrix<double>& matrix() const { return matrix_.matrix(); }
    /// A solution for one or more right-hand sides, of Eigen.
    template <class Vectors>
    auto solve(const Vectors& b) const {
        return solver_.solve(b);
    }
    block_work<double> work() const {
        return work_of_factors(solver_.entries_of_factors(), matrix_.matrix().rows());
    }
    /// About what factoring costs, in solves.
    double cost() const { return work().step / work().iteration; }
    long setups() const { return setups_; }

  private:
    shifted_sparse<double> matrix_;
    Solver solver_;
    double sigma_ = 0;
    bool exact_ = false;
    long setups_ = 0;
};

}  // namespace detail

/// The linear systems of a step with sparse J, all by one real factorisation where factoring is much more expensive than
/// solving, as with the fill of problems in two and three dimensions. It is that of gamma/h M - J, so that the real
/// system is solved directly; for a complex shift it preconditions GMRES, two real solves an iteration. Where the
/// eigenvalues of J h are real and negative, those of the preconditioned systems lie on an arc from 1 to the quotient of
/// the shifts, for Radau IIA with s = 3 of 49 degrees, and five iterations give three digits. The factors outlive J and h
/// while they serve (preconditioner_life.hpp); the real system is then solved by GMRES as well.
///
/// Where factoring costs little (one-dimensional problems, circuits), with mass matrices, and where these iterations turn
/// out to cost more than complex factors (little damping), every system is factored for itself, as in sparse_blocks.
/// RealSolver and ComplexSolver are solvers as sparse_blocks takes them that know entries_of_factors().
template <class RealSolver, class ComplexSolver>
class one_factor_blocks {
    using direct = sparse_blocks<double, RealSolver, ComplexSolver>;
    using factors = detail::kept_factors<RealSolver>;
    static constexpr double bound = 1e-2, expensive = 4;
    static constexpr int most = 40;

  public:
    /// For a real shift.
    class real {
      public:
        explicit real(int n) : n_(n) {}
        /// Factors shift M - J; false if it is singular or not finite.
        template <class Mass>
        bool factor_shifted(const Mass& mass, const Eigen::SparseMatrix<double>& J, double shift) {
            return n_ == 0 || factors_->set(mass, J, shift, false);
        }
        void solve(double* x) { solve_leaving(0, x); }
        static constexpr double usual_part() { return bound; }
        /// Where the factors are older than the matrix up to `part` of the right-hand side.
        void solve_leaving(double part, double* x) {
            if (n_ == 0) return;
            last_ = {};
            Eigen::Map<Eigen::VectorXd> map(x, n_);
            if (factors_->exact()) {
                map = factors_->solve(map).eval();
                life_.used(1);
                return;
            }
            last_ = gmres_.solve([&](const auto& in, auto&& out) { out.noalias() = factors_->matrix() * in; },
                                 [&](const auto& in, auto&& out) { out = factors_->solve(in); }, map,
                                 std::max(bound, part), most);
            life_.used(last_.iterations);
            if (!last_.failed()) return;
            life_
                .failed();  // the matrix is known: it is factored now, and again with the next one, which all systems share
            if (!factors_->factor()) return;
            map = factors_->solve(gmres_.right_hand_side());
            last_.end = linear_end::solved;
        }
        const linear_solve& last_solve() const { return last_; }
        /// As in sparse_blocks.
        step_work<double> work() const { return {{}, factors_->work()}; }
        /// Factorisations that have been made.
        long setups() const { return factors_->setups(); }

      private:
        friend one_factor_blocks;
        int n_;
        std::shared_ptr<factors> factors_ = std::make_shared<factors>();
        preconditioner_life life_;
        linear_solve last_;
        detail::restarted_gmres<double> gmres_;
    };

    /// For a complex shift re + i im; solve(x, y) takes real and imaginary parts.
    class complex {
        using number = std::complex<double>;

      public:
        explicit complex(int n) : n_(n), direct_(n), z_(n), right_(n, 2), left_(n, 2) {}
        /// Factors (re + i im) M - J; false if it is singular or not finite.
        template <class Mass>
        bool factor_shifted(const Mass& mass, const Eigen::SparseMatrix<double>& J, double re, double im) {
            factors_.reset();
            return direct_.factor_shifted(mass, J, re, im);
        }
        void solve(double* x, double* y) { solve_leaving(0, x, y); }
        static constexpr double usual_part() { return bound; }
        bool iterates() const { return factors_ != nullptr; }
        /// By iteration up to `part` of the right-hand side.
        void solve_leaving(double part, double* x, double* y) {
            last_ = {};
            if (!iterates()) {
                direct_.solve(x, y);
                return;
            }
            for (int i = 0; i < n_; ++i) z_[i] = number(x[i], y[i]);
            last_ = gmres_.solve(
                [&](const auto& in, auto&& out) {
                    out.noalias() = factors_->matrix() * in;
                    out += (shift_ - factors_->sigma()) * in;
                },
                [&](const auto& in, auto&& out) {
                    right_.col(0) = in.real();
                    right_.col(1) = in.imag();
                    left_ = factors_->solve(right_);
                    out.real() = left_.col(0);
                    out.imag() = left_.col(1);
                },
                z_, std::max(bound, part), most);
            life_.used(last_.iterations);
            solves_ += 2 * last_.iterations;
            if (last_.failed()) {
                solve_directly(x, y);
                return;
            }
            for (int i = 0; i < n_; ++i) x[i] = z_[i].real(), y[i] = z_[i].imag();
        }
        const linear_solve& last_solve() const { return last_; }
        /// As in sparse_blocks; where one factorisation serves all systems, half of one a step, and for each stage of an
        /// iteration one and a half solves, as measured.
        step_work<double> work() const {
            if (!iterates()) return direct_.work();
            const auto one = factors_->work();
            return {{one.step / 2, 0}, {0, one.iteration * 3 / 2}};
        }

      private:
        friend one_factor_blocks;
        /// New factors of the real system are there: iterates with them where these are expensive and the iterations
        /// with those before have not been.
        void share(const std::shared_ptr<factors>& real) {
            const double cost = real->cost();
            slow_ = slow_ || static_cast<double>(solves_) > 4 * cost * static_cast<double>(matrices_);
            factors_ = !slow_ && cost > expensive ? real : nullptr;
            solves_ = matrices_ = 0;
            life_.made(real->sigma(), cost);
        }
        /// The iteration has failed for the right-hand side x + i y: factors of its own from now on.
        void solve_directly(double* x, double* y) {
            Eigen::SparseMatrix<double> J = -factors_->matrix();
            for (int i = 0; i < n_; ++i) J.coeffRef(i, i) += factors_->sigma();
            slow_ = true;
            factors_.reset();
            if (!direct_.factor_shifted(identity_mass(), J, shift_.real(), shift_.imag())) {
                std::fill_n(x, n_, std::numeric_limits<double>::quiet_NaN());
                return;
            }
            direct_.solve(x, y);
            last_.end = linear_end::solved;
        }
        template <class Mass>
        bool take(const Mass& mass, const Eigen::SparseMatrix<double>& J, const number& shift) {
            if (!iterates()) return direct_.factor_shifted(mass, J, shift.real(), shift.imag());
            ++matrices_;
            shift_ = shift;
            return true;
        }

        int n_;
        typename direct::complex direct_;
        std::shared_ptr<factors> factors_;  // where they are shared
        number shift_;
        long solves_ = 0, matrices_ = 0;  // real ones, and matrices, since they were made
        bool slow_ = false;
        preconditioner_life life_;
        linear_solve last_;
        Eigen::VectorXcd z_;
        Eigen::Matrix<double, Eigen::Dynamic, 2> right_, left_;
        detail::restarted_gmres<number> gmres_;
    };

    /// Factors for the shifts of a step, those of pairs as real and imaginary part; false if a matrix is singular or not
    /// finite.
    template <class Mass>
    static bool factor_all(std::vector<real>& reals, std::vector<complex>& pairs, const Mass& mass,
                           const Eigen::SparseMatrix<double>& J, const double* shift) {
        if (!Mass::identity || reals.size() != 1 || J.rows() == 0) {
            for (auto& block : reals)
                if (!block.factor_shifted(mass, J, *shift++)) return false;
            for (auto& pair : pairs) {
                if (!pair.factor_shifted(mass, J, shift[0], shift[1])) return false;
                shift += 2;
            }
            return true;
        }
        real& first = reals[0];
        const double sigma = *shift++;
        const bool keep = first.life_.serves(sigma) && kept_by(pairs, sigma);
        if (!first.factors_->set(mass, J, sigma, keep)) {
            first.life_ = {};
            return false;
        }
        if (first.factors_->exact()) {
            first.life_.made(sigma, first.factors_->cost());
            for (auto& pair : pairs) pair.share(first.factors_);
        }
        for (auto& pair : pairs) {
            if (!pair.take(mass, J, {shift[0], shift[1]})) return false;
            shift += 2;
        }
        return true;
    }

  private:
    /// Some pair uses the factors of the real system, and none finds them too old for sigma.
    static bool kept_by(const std::vector<complex>& pairs, double sigma) {
        bool used = false, old = false;
        for (const auto& pair : pairs)
            if (pair.iterates()) used = true, old = old || !pair.life_.serves(sigma);
        return used && !old;
    }
};

}  // namespace stagecraft
