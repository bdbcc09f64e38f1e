// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include <stagecraft/linear/norms.hpp>
#include <stagecraft/method/structure.hpp>
#include <stagecraft/stages/coupled_systems.hpp>
#include <stagecraft/stages/newton.hpp>
#include <stagecraft/stages/stage_slopes.hpp>
#include <stagecraft/work.hpp>

namespace stagecraft {

/// The stages of any method as one system for the slopes, M k_i = f(t + c_i h, y + h sum_j a_ij k_j), solved
/// by simplified Newton with the factors of I (x) M - h A (x) J, made once per (J, h). A may be singular; a
/// first stage that is the left end of the step is left out of the system. All storage is taken in the
/// constructor.
template <class Vector, int Stages, class Blocks>
class coupled_stages {
    using Scalar = typename Vector::Scalar;

  public:
    using slopes = stage_slopes<Vector, Stages, Blocks>;
    using vector = Vector;

    /// For a lower triangular A no storage is taken, and no other member may be called.
    coupled_stages(const tableau<Scalar, Stages>& m, int n, const tableau_structure& is)
        : n_(n),
          first_(is.left_stage ? 1 : 0),
          count_(is.lower ? 0 : m.stages() - first_),
          systems_(coupled_part(m), count_, n, is.regular()),
          x_(static_cast<std::size_t>(count_ * n)),
          yi_(n),
          fi_(n) {}

    /// True if the systems are solved by eigenvectors of A: what a Jacobian whose entries are not known asks for.
    bool splits() const { return !systems_.exact(); }
    template <class System>
    bool factor(const System& system, const Scalar& h) {
        return system.measure(work::factorisation, [&] { return systems_.factor(system, h); });
    }

    /// Computes the slopes, from a first guess in v.k; Z takes z_i = Y_i - y in its columns.
    template <class System, class Norm, class StageMatrix>
    newton_outcome<Scalar> solve(System& system, const Scalar& t, const vector& y, const Scalar& h,
                                 const Norm& norm, const newton_limits<Scalar>& limits, slopes& v,
                                 StageMatrix& Z, long& solves) {
        const auto& m = v.method;
        const int s = m.stages();
        newton_limits<Scalar> told = limits;
        told.affine = limits.affine && systems_.exact();
        newton_monitor<Scalar> monitor(told);
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
            Scalar residual(0);
            if constexpr (inexact_blocks<Blocks, Scalar>) residual = largest(norm);
            system.measure(work::solve, [&] { systems_.solve(system, x_, v.mass); });
            if constexpr (inexact_blocks<Blocks, Scalar>)
                systems_.left().tell(monitor, Scalar(0), residual, Scalar(Scalar(1) / h));
            ++solves;
            for (int i = first_; i < s; ++i)
                for (int r = 0; r < n_; ++r) v.k(r, i) += x_[(i - first_) * n_ + r];
            if (monitor.over(change(m, h, norm))) break;
        }
        for (int i = 0; i < s; ++i) {
            v.combine([&](int j) { return m.A(i, j); }, s, h, yi_);
            Z.col(i) = yi_;
        }
        return monitor.outcome();
    }

    /// x := the last component of (I (x) M - h A (x) J)^-1 (1 (x) (M x + factor value)). For a stiffly
    /// accurate method with regular A this damps an estimate in the same way as the method damps Y_s.
    template <class System>
    void filter(const System& system, vector& x, slopes& v, const Scalar& factor) {
        yi_ = factor * v.left;
        add_mass_times(system.mass(), Scalar(1), x.data(), yi_.data(), n_);
        x = yi_;
        solve_last(system, x, v);
    }
    /// x := the last component of (I (x) M - h A (x) J)^-1 (1 (x) x).
    template <class System>
    void solve_last(const System& system, vector& x, slopes& v) {
        for (int i = 0; i < count_; ++i)
            for (int r = 0; r < n_; ++r) x_[i * n_ + r] = x[r];
        system.measure(work::solve, [&] { systems_.solve(system, x_, v.mass); });
        for (int r = 0; r < n_; ++r) x[r] = x_[(count_ - 1) * n_ + r];
    }

  private:
    /// The size of the largest right-hand side in x_.
    template <class Norm>
    Scalar largest(const Norm& norm) {
        Scalar most(0);
        for (int i = 0; i < count_; ++i) {
            for (int r = 0; r < n_; ++r) fi_[r] = x_[i * n_ + r];
            const Scalar one = norm(fi_);
            if (!(one <= most)) most = one;
        }
        return most;
    }
    std::vector<Scalar> coupled_part(const tableau<Scalar, Stages>& m) const {
        std::vector<Scalar> a;
        for (int j = 0; j < count_; ++j)
            for (int i = 0; i < count_; ++i) a.push_back(m.A(first_ + i, first_ + j));
        return a;
    }

    /// Size of the increments of the z_i and of y1 that result, through A and b, from the increments of the
    /// slopes in x_.
    template <class Norm>
    Scalar change(const tableau<Scalar, Stages>& m, const Scalar& h, const Norm& norm) {
        using std::sqrt;
        if constexpr (!std::remove_cvref_t<decltype(norm.sums())>::complete) {
            const auto squares = [&](const Scalar& unit) {
                Scalar sum(0);
                for (int i = first_; i <= m.stages(); ++i) {
                    increment(m, h, i);
                    sum += (fi_.array() * norm.weights().array() * unit).square().sum();
                }
                return sum / Scalar(count_ + 1);
            };
            return added_norm<Scalar>(squares, n_, norm.sums());
        }
        Scalar sum = Scalar(0), largest = Scalar(0);
        for (int i = first_; i <= m.stages(); ++i) {
            increment(m, h, i);
            const Scalar size = norm(fi_);
            sum += size * size;
            if (!(size <= largest)) largest = size;
        }
        return sum - sum == Scalar(0) ? Scalar(sqrt(sum / Scalar(count_ + 1))) : largest;
    }

    /// fi_ := the increment of z_i, or of y1 for i = s, from that of the slopes in x_.
    void increment(const tableau<Scalar, Stages>& m, const Scalar& h, int i) {
        fi_.setZero();
        for (int j = 0; j < count_; ++j) {
            const Scalar a = i < m.stages() ? m.A(i, first_ + j) : m.b[first_ + j];
            for (int r = 0; r < n_; ++r) fi_[r] += h * a * x_[j * n_ + r];
        }
    }

    int n_, first_, count_;
    coupled_systems<Scalar, Blocks> systems_;
    std::vector<Scalar> x_;
    vector yi_, fi_;
};

}  // namespace stagecraft
