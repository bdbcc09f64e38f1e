// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/columns.hpp>
#include <stagecraft/linear/complex_pair.hpp>
#include <stagecraft/linear/sparse_elimination.hpp>

namespace stagecraft {

/// The systems (shift I - J) x = r of a step, where J is dense but most of its entries are zero: as their entries are in the
/// same places, one order serves all, and two of them are factored and solved at once. They are the complex ones
/// two by two; of an odd number the last one goes with the real one, if there is one, else with itself.
template <class Scalar>
class sparse_pairs {
  public:
    sparse_pairs(int real, int complex) : reals_(real), complexes_(complex) {}

    /// Factors all of them, for real shifts and then pairs of numbers for complex ones. False if they are not for this
    /// class, or one needs pivots beside the diagonal.
    template <class Matrix>
    bool factor(const Matrix& J, const Scalar* shift) {
        factored_ = false;
        const int n = static_cast<int>(J.rows());
        if (reals_ > 1 || !few_.read(shifted{J.data(), n, Scalar(0)}, n)) return false;
        if (few_.changed() || systems_.empty()) resize(n);
        if (alone() && !real_.factor(order(), shifted{J.data(), n, *shift})) return false;
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            shifted_pair a{J.data(), {}};
            for (int l = 0; l < 2; ++l) {
                const int first = systems_[k][l];
                a.shift.re[l] = shift[first];
                a.shift.im[l] = first < reals_ ? Scalar(0) : shift[first + 1];
            }
            if (!pairs_[k].factor(order(), a)) return false;
        }
        return factored_ = true;
    }
    bool factored() const { return factored_; }
    /// What one system costs.
    block_work<Scalar> work() const {
        if (!factored_) return {Scalar(0), Scalar(0)};
        return {Scalar(8 * order().size()), Scalar(2 * order().size())};
    }

    /// Solves all in place; the right-hand sides follow each other as the shifts do, n numbers each.
    void solve(Scalar* x) {
        if (alone()) solve_real(x);
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            std::array<Scalar*, 2> re, im;
            for (int l = 0; l < 2; ++l) {
                const int first = systems_[k][l];
                re[l] = x + first * n_;
                im[l] = first < reals_ ? nullptr : re[l] + n_;
            }
            const auto get = [&](int i) {
                complex_pair<Scalar> v(Scalar(0));
                for (int l = 0; l < 2; ++l) {
                    v.re[l] = re[l][i];
                    if (im[l]) v.im[l] = im[l][i];
                }
                return v;
            };
            pairs_[k].solve(order(), get, [&](int i, const complex_pair<Scalar>& v) {
                for (int l = 0; l < 2; ++l) {
                    re[l][i] = v.re[l];
                    if (im[l]) im[l][i] = v.im[l];
                }
            });
        }
    }
    /// Solves with the first system alone: the real one, else the first complex one for x + i y.
    void solve_first(Scalar* x, Scalar* y) {
        if (alone()) return solve_real(x);
        const auto& factors = reals_ > 0 ? pairs_.back() : pairs_.front();
        if (reals_ > 0) {
            one_.resize(static_cast<std::size_t>(n_));
            factors.solve(
                order(), one_, [](const complex_pair<Scalar>& v) { return v.re[0]; },
                [&](int i) { return x[i]; }, [&](int i, const Scalar& v) { x[i] = v; });
        } else {
            using number = complex_number<Scalar>;
            first_.resize(static_cast<std::size_t>(n_));
            factors.solve(
                order(), first_,
                [](const complex_pair<Scalar>& v) {
                    return number{v.re[0], v.im[0]};
                },
                [&](int i) {
                    return number{x[i], y[i]};
                },
                [&](int i, const number& v) { x[i] = v.re, y[i] = v.im; });
        }
    }
    /// Of the real system.
    bool negative_determinant() const {
        bool negative = false;
        for (int k = 0; k < n_; ++k)
            negative ^= (alone() ? real_.inverse_pivot(order(), k)
                                 : pairs_.back().inverse_pivot(order(), k).re[0]) < Scalar(0);
        return negative;
    }

  private:
    /// shift I - J.
    struct shifted {
        const Scalar* J;
        int n;
        Scalar shift;
        bool holds(std::ptrdiff_t place) const { return !is_zero(J[place]) || place % (n + 1) == 0; }
        int zeros(int places) const {
            int count = real_column<Scalar>{const_cast<Scalar*>(J)}.zeros(places);
            for (int i = 0; i < n; ++i) count -= is_zero(J[i + i * n]);
            return count;
        }
        Scalar operator[](std::ptrdiff_t place) const { return -J[place]; }
        Scalar on_diagonal(std::ptrdiff_t place) const { return shift - J[place]; }
    };
    struct shifted_pair {
        const Scalar* J;
        complex_pair<Scalar> shift;
        complex_pair<Scalar> operator[](std::ptrdiff_t place) const {
            return complex_pair<Scalar>(-J[place]);
        }
        complex_pair<Scalar> on_diagonal(std::ptrdiff_t place) const {
            return shift - complex_pair<Scalar>(J[place]);
        }
    };

    const elimination_order& order() const { return few_.order(); }
    /// The real system is in no pair.
    bool alone() const { return reals_ > 0 && complexes_ % 2 == 0; }
    void resize(int n) {
        n_ = n;
        systems_.clear();
        for (int k = 0; k + 1 < complexes_; k += 2) systems_.push_back({reals_ + 2 * k, reals_ + 2 * k + 2});
        const int last = reals_ + 2 * (complexes_ - 1);
        if (complexes_ % 2 != 0) systems_.push_back({reals_ > 0 ? 0 : last, last});
        pairs_.resize(systems_.size());
        for (auto& pair : pairs_) pair.resize(order(), n);
        if (alone()) real_.resize(order(), n);
    }
    void solve_real(Scalar* x) {
        real_.solve(
            order(), [&](int i) { return x[i]; }, [&](int i, const Scalar& v) { x[i] = v; });
    }

    int reals_, complexes_, n_ = 0;
    few_entries few_;
    std::vector<std::array<int, 2>>
        systems_;  // of each pair: where its shifts begin, and its right-hand sides, in columns
    std::vector<sparse_factors<Scalar, complex_pair<Scalar>>> pairs_;
    sparse_factors<Scalar, Scalar> real_;
    std::vector<Scalar> one_;
    std::vector<complex_number<Scalar>> first_;
    bool factored_ = false;
};

/// Where no J is dense, or so small that its zeros do not matter.
struct no_sparse_pairs {
    no_sparse_pairs(int, int) {}
};

}  // namespace stagecraft
