// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <array>
#include <cmath>
#include <limits>

#include <stagecraft/linear/linear_solve.hpp>

namespace stagecraft::detail {

/// Flexible GMRES with restarts, preconditioned from the right: x, the right-hand side, becomes the solution to a
/// relative residual of `bound`; NaN where `most` iterations do not reach it, or something is not finite. Keeps
/// 2 (restart + 1) vectors, taken at the first call. Number is double or std::complex<double>.
template <class Number>
class restarted_gmres {
  public:
    using vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

    /// multiply(in, out) and precondition(in, out).
    template <class Multiply, class Precondition>
    linear_solve solve(Multiply&& multiply, Precondition&& precondition, Eigen::Ref<vector> x, double bound,
                       int most) {
        take(x.size());
        b_ = x;
        const double whole = b_.norm();
        if (whole == 0) return {};
        x.setZero();
        w_ = b_;
        double rest = whole;
        linear_solve done;
        done.end = std::isfinite(whole) ? linear_end::unconverged : linear_end::not_finite;
        while (done.end == linear_end::unconverged && rest > bound * whole && done.iterations < most) {
            const int k =
                cycle(multiply, precondition, rest, bound * whole, most - done.iterations, done.end);
            done.iterations += k;
            const auto y =
                H_.topLeftCorner(k, k).template triangularView<Eigen::Upper>().solve(g_.head(k)).eval();
            x.noalias() += Z_.leftCols(k) * y;
            multiply(x, w_);
            w_ = b_ - w_;
            rest = w_.norm();
        }
        if (rest <= bound * whole)
            done.end = linear_end::solved;
        else
            x.setConstant(std::numeric_limits<double>::quiet_NaN());
        return done;
    }
    /// Of the last solve.
    const vector& right_hand_side() const { return b_; }

  private:
    static constexpr int restart = 10;

    void take(Eigen::Index n) {
        if (w_.size() == n) return;
        V_.resize(n, restart + 1);
        Z_.resize(n, restart);
        w_.resize(n);
        b_.resize(n);
    }
    /// From the residual in w_; leaves the triangular factor in H_ and the right-hand side in g_. Returns its size. Says in
    /// `end` what makes further cycles useless.
    template <class Multiply, class Precondition>
    int cycle(Multiply& multiply, Precondition& precondition, double rest, double goal, int most,
              linear_end& end) {
        H_.setZero();
        g_.setZero();
        g_[0] = rest;
        V_.col(0) = w_ / rest;
        int k = 0;
        while (k < restart && k < most) {
            precondition(V_.col(k), Z_.col(k));
            multiply(Z_.col(k), w_);
            for (int i = 0; i <= k; ++i) {
                H_(i, k) = V_.col(i).dot(w_);
                w_ -= H_(i, k) * V_.col(i);
            }
            const double next = w_.norm();
            H_(k + 1, k) = next;
            for (int i = 0; i < k; ++i) H_.col(k).applyOnTheLeft(i, i + 1, turn_[std::size_t(i)].adjoint());
            turn_[std::size_t(k)].makeGivens(H_(k, k), H_(k + 1, k));
            H_.col(k).applyOnTheLeft(k, k + 1, turn_[std::size_t(k)].adjoint());
            if (!std::isfinite(next) || H_(k, k) == Number(0)) {
                end = breakdown(Z_.col(k), next);
                return k;
            }
            g_.applyOnTheLeft(k, k + 1, turn_[std::size_t(k)].adjoint());
            ++k;
            if (!(std::abs(g_[k]) > goal) || next == 0) break;
            V_.col(k) = w_ / next;
        }
        return k;
    }

    /// Why the product of size `next` with z, which the preconditioner gave, leads no further.
    template <class Column>
    static linear_end breakdown(const Column& z, double next) {
        if (!z.allFinite() || z.isZero(0)) return linear_end::bad_preconditioner;
        return std::isfinite(next) ? linear_end::unconverged : linear_end::not_finite;
    }

    Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> V_, Z_;
    vector w_, b_;
    Eigen::Matrix<Number, restart + 1, restart> H_;
    Eigen::Matrix<Number, restart + 1, 1> g_;
    std::array<Eigen::JacobiRotation<Number>, restart> turn_;
};

}  // namespace stagecraft::detail
