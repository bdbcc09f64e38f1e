// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include <stagecraft/control/weighted_norm.hpp>
#include <stagecraft/linear/dense_blocks.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/stages/stage_slopes.hpp>
#include <stagecraft/work.hpp>

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

/// The stages of any method as one system for the slopes, M k_i = f(t + c_i h, y + h sum_j a_ij k_j), solved
/// by simplified Newton with one dense LU of I (x) M - h A (x) J per (J, h): (s n)^3 operations, whatever the
/// structure of J. A may be singular; a first stage that is the left end of the step is left out of the
/// system. All storage is taken in the constructor.
template <class Scalar, int N, int Stages, class Blocks>
class coupled_stages {
  public:
    using slopes = stage_slopes<Scalar, N, Stages, Blocks>;
    using vector = typename slopes::vector;

    /// With `unused` true no storage is taken and no member may be called.
    coupled_stages(const tableau<Scalar, Stages>& m, int n, int first, bool unused)
        : n_(n),
          first_(first),
          count_(unused ? 0 : m.stages() - first),
          lu_(count_ * n),
          x_(count_ * n),
          yi_(n),
          fi_(n) {}

    /// Factors I (x) M - h A (x) J over the coupled stages; false if it is singular or not finite.
    template <class System>
    bool factor(const System& system, const Scalar& h, const slopes& v) {
        const int m = count_ * n_;
        Scalar* e = lu_.entries();
        for (int i = 0; i < m * m; ++i) e[i] = Scalar(0);
        for (int j = 0; j < count_; ++j)
            for (int i = 0; i < count_; ++i) {
                const Scalar a = h * v.method.A(first_ + i, first_ + j);
                if (a == Scalar(0)) continue;
                detail::for_each_entry(system.jacobian(), [&](int r, int c, const Scalar& value) {
                    e[i * n_ + r + (j * n_ + c) * m] -= a * value;
                });
            }
        for (int i = 0; i < count_; ++i) add_mass(system.mass(), Scalar(1), e + i * n_ * (m + 1), m, n_);
        return system.measure(work::factorisation, [&] { return lu_.factor(); });
    }

    /// Computes the slopes, from a first guess in v.k; Z takes z_i = Y_i - y in its columns.
    template <class System, class StageMatrix>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const vector& weights, const newton_limits<Scalar>& limits, slopes& v,
                                 StageMatrix& Z, long& solves) {
        const auto& m = v.method;
        const int s = m.stages();
        newton_monitor<Scalar> monitor(limits);
        if (!v.guessed) v.k.rightCols(count_).setZero();
        while (monitor.may_go_on()) {
            for (int i = first_; i < s; ++i) {
                v.combine([&](int j) { return m.A(i, j); }, s, h, yi_);
                yi_ += y;
                system(t + m.c[i] * h, yi_, fi_);
                yi_ = v.k.col(i);
                add_mass_times(system.mass(), Scalar(-1), yi_.data(), fi_.data(), n_);
                if (v.by_value) fi_ -= v.carry[i] * v.left;
                for (int r = 0; r < n_; ++r) x_[(i - first_) * n_ + r] = fi_[r];
            }
            system.measure(work::solve, [&] { lu_.solve(x_.data()); });
            ++solves;
            for (int i = first_; i < s; ++i)
                for (int r = 0; r < n_; ++r) v.k(r, i) += x_[(i - first_) * n_ + r];
            if (monitor.over(change(m, h, weights))) break;
        }
        for (int i = 0; i < s; ++i) {
            v.combine([&](int j) { return m.A(i, j); }, s, h, yi_);
            Z.col(i) = yi_;
        }
        return monitor.outcome();
    }

    /// x := the last component of (I (x) M - h A (x) J)^-1 (1 (x) (M x + factor value)): for a stiffly
    /// accurate method with regular A the estimate damped as Y_s is.
    template <class System>
    void filter(const System& system, vector& x, const vector& value, const Scalar& factor) {
        yi_ = factor * value;
        add_mass_times(system.mass(), Scalar(1), x.data(), yi_.data(), n_);
        for (int i = 0; i < count_; ++i)
            for (int r = 0; r < n_; ++r) x_[i * n_ + r] = yi_[r];
        system.measure(work::solve, [&] { lu_.solve(x_.data()); });
        for (int r = 0; r < n_; ++r) x[r] = x_[(count_ - 1) * n_ + r];
    }

  private:
    /// Adds M to a diagonal block of a matrix with leading dimension `leading`.
    static void add_mass(const identity_mass&, const Scalar& one, Scalar* e, int leading, int n) {
        for (int i = 0; i < n; ++i) e[i + i * leading] += one;
    }
    static void add_mass(const entry_mass<Scalar>& mass, const Scalar& one, Scalar* e, int leading, int) {
        for (const auto& entry : mass.entries()) e[entry.row + entry.column * leading] += one * entry.value;
    }

    /// Size of the increments of the z_i and of y1 that belong to the slopes' increments in x_: what of them
    /// A and b let through.
    Scalar change(const tableau<Scalar, Stages>& m, const Scalar& h, const vector& weights) {
        using std::sqrt;
        Scalar sum = Scalar(0), largest = Scalar(0);
        for (int i = first_; i <= m.stages(); ++i) {
            fi_.setZero();
            for (int j = 0; j < count_; ++j) {
                const Scalar a = i < m.stages() ? m.A(i, first_ + j) : m.b[first_ + j];
                for (int r = 0; r < n_; ++r) fi_[r] += h * a * x_[j * n_ + r];
            }
            const Scalar size = weighted_norm(fi_, weights, n_);
            sum += size * size;
            if (!(size <= largest)) largest = size;
        }
        return sum - sum == Scalar(0) ? Scalar(sqrt(sum / Scalar(count_ + 1))) : largest;
    }

    int n_, first_, count_;
    typename dense_blocks<Scalar, Eigen::Dynamic>::real lu_;
    std::vector<Scalar> x_;
    vector yi_, fi_;
};

}  // namespace stagecraft
