// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <array>
#include <cmath>
#include <limits>

namespace stagecraft::detail {

/// Flexible GMRES with restarts, preconditioned from the right: x, the right-hand side, becomes the solution to a
/// relative residual of `bound`, or what `most` iterations have made of it; NaN if it is not finite. Keeps
/// 2 (restart + 1) vectors, taken at the first call. Number is double or std::complex<double>.
template <class Number>
class restarted_gmres {
  public:
    using vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

    /// multiply(in, out) and precondition(in, out); returns the iterations.
    template <class Multiply, class Precondition>
    int solve(Multiply&& multiply, Precondition&& precondition, Eigen::Ref<vector> x, double bound,
              int most) {
        take(x.size());
        b_ = x;
        const double whole = b_.norm();
        if (whole == 0) return 0;
        x.setZero();
        w_ = b_;
        double rest = whole;
        int iterations = 0;
        while (rest > bound * whole && iterations < most) {
            const int k = cycle(multiply, precondition, rest, bound * whole, most - iterations);
            iterations += k;
            const auto y =
                H_.topLeftCorner(k, k).template triangularView<Eigen::Upper>().solve(g_.head(k)).eval();
            x.noalias() += Z_.leftCols(k) * y;
            multiply(x, w_);
            w_ = b_ - w_;
            rest = w_.norm();
        }
        if (!std::isfinite(rest)) x.setConstant(std::numeric_limits<double>::quiet_NaN());
        return iterations;
    }

  private:
    static constexpr int restart = 10;

    void take(Eigen::Index n) {
        if (w_.size() == n) return;
        V_.resize(n, restart + 1);
        Z_.resize(n, restart);
        w_.resize(n);
        b_.resize(n);
    }
    /// From the residual in w_; leaves the triangular factor in H_ and the right-hand side in g_. Returns its size.
    template <class Multiply, class Precondition>
    int cycle(Multiply& multiply, Precondition& precondition, double rest, double goal, int most) {
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
            g_.applyOnTheLeft(k, k + 1, turn_[std::size_t(k)].adjoint());
            ++k;
            if (!(std::abs(g_[k]) > goal) || next == 0) break;
            V_.col(k) = w_ / next;
        }
        return k;
    }

    Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> V_, Z_;
    vector w_, b_;
    Eigen::Matrix<Number, restart + 1, restart> H_;
    Eigen::Matrix<Number, restart + 1, 1> g_;
    std::array<Eigen::JacobiRotation<Number>, restart> turn_;
};

}  // namespace stagecraft::detail
