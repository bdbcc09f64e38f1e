// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <stagecraft/linear/block_diagonal.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/split_complex.hpp>
#include <stagecraft/stages/together.hpp>

namespace stagecraft {

namespace detail {

/// Calls visit(i, j, value) for every stored entry of a dense, banded or sparse Jacobian.
template <class Matrix, class Visit>
void for_each_entry(const Matrix& J, Visit visit) {
    const int n = static_cast<int>(J.rows());
    if constexpr (requires {
                      typename Matrix::InnerIterator;
                      J.isCompressed();
                  }) {
        for (Eigen::Index k = 0; k < J.outerSize(); ++k)
            for (typename Matrix::InnerIterator it(J, k); it; ++it)
                visit(static_cast<int>(it.row()), static_cast<int>(it.col()), it.value());
    } else {
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                if constexpr (requires { J.in_band(i, j); }) {
                    if (!J.in_band(i, j)) continue;
                }
                visit(i, j, J(i, j));
            }
    }
}

}  // namespace detail

/// The linear systems (I (x) M - h A (x) J) x = r of coupled stages, A being m x m. Where A has a basis of
/// eigenvectors they fall into one system of size n per real eigenvalue lambda and one complex one per pair,
/// M/(h lambda) - J, in the structure of J, or M where lambda is zero. Else one dense LU of size m n. The
/// basis is found in doubles whatever the scalar is, so that solutions are good to some 10 digits: enough for
/// an iteration that evaluates its residuals itself.
template <class Scalar, class Blocks>
class coupled_systems {
  public:
    coupled_systems(const std::vector<Scalar>& A, int m, int n, bool regular)
        : n_(n), m_(m), A_(A), lu_(0), work_(static_cast<std::size_t>(m * n)) {
        std::vector<double> a;
        for (const Scalar& x : A) a.push_back(static_cast<double>(x));
        const auto form = block_diagonal(a, m);
        split_ = form.has_value();
        if (!split_) {
            lu_ = dense(m * n);
            return;
        }
        double largest = 0;
        for (const double x : form->real) largest = std::max(largest, std::abs(x));
        for (const auto& x : form->pairs) largest = std::max(largest, std::abs(x));
        for (const double x : form->real) {
            real_.push_back(regular || std::abs(x) > 1e-8 * largest ? Scalar(x) : Scalar(0));
            real_blocks_.emplace_back(n);
        }
        for (const auto& x : form->pairs) {
            pairs_.push_back({Scalar(x.real()), Scalar(x.imag())});
            pair_blocks_.emplace_back(n);
        }
        real_shift_.resize(real_.size());
        pair_shift_.resize(pairs_.size());
        T_.assign(form->T.begin(), form->T.end());
        T_inverse_.assign(form->T_inverse.begin(), form->T_inverse.end());
    }

    /// True if solutions are good to rounding.
    bool exact() const { return !split_; }

    /// False if a system is singular or not finite.
    template <class System>
    bool factor(const System& system, const Scalar& h) {
        if (!split_) return factor_dense(system, h);
        for (std::size_t k = 0; k < real_.size(); ++k) {
            if (real_[k] == Scalar(0)) continue;
            real_shift_[k] = Scalar(1) / (h * real_[k]);
            if (!factor_together(system, real_blocks_[k], real_shift_[k])) return false;
        }
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            auto& [re, im] = pair_shift_[k];
            reciprocal(Scalar(h * pairs_[k][0]), Scalar(-h * pairs_[k][1]), re, im);
            if (!factor_together(system, pair_blocks_[k], re, im)) return false;
        }
        return true;
    }

    /// What their last solves have left.
    left_by_solvers<Scalar> left() const {
        left_by_solvers<Scalar> all;
        for (const auto& block : real_blocks_) all.add(block);
        for (const auto& block : pair_blocks_) all.add(block);
        return all;
    }
    /// Solves in place, stage by stage n numbers; `mass` solves with M.
    template <class System, class Mass>
    void solve(const System& system, std::vector<Scalar>& x, Mass& mass) {
        if (!split_) {
            lu_.solve(x.data());
            return;
        }
        mix(T_inverse_, x, work_);
        Scalar* w = work_.data();
        for (std::size_t k = 0; k < real_.size(); ++k, w += n_) {
            if (real_[k] == Scalar(0)) {
                mass.solve(w);
                continue;
            }
            for (int i = 0; i < n_; ++i) w[i] *= real_shift_[k];
            solve_together(system, real_blocks_[k], [&] { real_blocks_[k].solve(w); });
        }
        for (std::size_t k = 0; k < pairs_.size(); ++k, w += 2 * n_) {
            const auto& [re, im] = pair_shift_[k];
            for (int i = 0; i < n_; ++i) {
                const Scalar a = w[i], b = w[i + n_];
                w[i] = a * re - b * im;
                w[i + n_] = a * im + b * re;
            }
            solve_together(system, pair_blocks_[k], [&] { pair_blocks_[k].solve(w, w + n_); });
        }
        mix(T_, work_, x);
    }

  private:
    using dense = typename dense_blocks<Scalar, Eigen::Dynamic>::real;

    void mix(const std::vector<Scalar>& C, const std::vector<Scalar>& in, std::vector<Scalar>& out) const {
        for (int k = 0; k < m_; ++k)
            for (int i = 0; i < n_; ++i) {
                Scalar sum = Scalar(0);
                for (int j = 0; j < m_; ++j) sum += C[k + j * m_] * in[i + j * n_];
                out[i + k * n_] = sum;
            }
    }

    template <class System>
    bool factor_dense(const System&,
                      const Scalar&) requires(System::opaque || !has_entries<typename System::mass_type>) {
        return false;  // tableau_step::prepare has refused it
    }
    template <class System>
    bool factor_dense(const System& system, const Scalar& h) {
        const int m = m_ * n_;
        Scalar* e = lu_.entries();
        for (int i = 0; i < m * m; ++i) e[i] = Scalar(0);
        for (int j = 0; j < m_; ++j)
            for (int i = 0; i < m_; ++i) {
                const Scalar a = h * A_[i + j * m_];
                if (a == Scalar(0)) continue;
                detail::for_each_entry(system.jacobian(), [&](int r, int c, const Scalar& value) {
                    e[i * n_ + r + (j * n_ + c) * m] -= a * value;
                });
            }
        for (int i = 0; i < m_; ++i) add_mass(system.mass(), e + i * n_ * (m + 1), m, n_);
        return lu_.factor();
    }
    /// Adds M to a diagonal block of a matrix with leading dimension `leading`.
    static void add_mass(const identity_mass&, Scalar* e, int leading, int n) {
        for (int i = 0; i < n; ++i) e[i + i * leading] += Scalar(1);
    }
    static void add_mass(const entry_mass<Scalar>& mass, Scalar* e, int leading, int) {
        for (const auto& entry : mass.entries()) e[entry.row + entry.column * leading] += entry.value;
    }

    int n_, m_;
    bool split_ = false;
    std::vector<Scalar> A_, real_, real_shift_, T_, T_inverse_;  // matrices column by column
    std::vector<std::array<Scalar, 2>> pairs_, pair_shift_;      // real and imaginary parts
    std::vector<typename Blocks::real> real_blocks_;
    std::vector<typename Blocks::complex> pair_blocks_;
    dense lu_;
    std::vector<Scalar> work_;
};

}  // namespace stagecraft
