// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <complex>

#include <stagecraft/linear/split_complex.hpp>

namespace stagecraft {

/// Blocked LU with row pivoting of a dense real matrix of run-time size (Eigen's PartialPivLU).
template <class Scalar>
class dense_lu {
  public:
    explicit dense_lu(int n) : a_(n, n), x_(n), lu_(n), seen_(n) {}

    Scalar* entries() { return a_.data(); }

    bool factor() {
        using std::abs;
        if (a_.size() == 0) return true;
        lu_.compute(a_);
        for (Eigen::Index i = 0; i < a_.rows(); ++i)
            if (!usable_pivot(Scalar(abs(lu_.matrixLU()(i, i))))) return false;
        return true;
    }

    /// Sign of the determinant of the matrix last factored.
    bool negative_determinant() {
        if (a_.size() == 0) return false;
        bool negative = false;
        seen_.setConstant(false);
        const auto& to = lu_.permutationP().indices();
        for (Eigen::Index i = 0; i < a_.rows(); ++i) {
            negative ^= lu_.matrixLU()(i, i) < Scalar(0);
            for (Eigen::Index k = i; !seen_[k]; k = to[k]) {  // a cycle of length l is l - 1 exchanges
                seen_[k] = true;
                negative ^= to[k] != i;
            }
        }
        return negative;
    }

    void solve(Scalar* x) {
        if (a_.size() == 0) return;
        Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>> map(x, a_.rows());
        x_ = lu_.solve(map);
        map = x_;
    }

  private:
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> a_;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> x_;
    Eigen::PartialPivLU<Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>> lu_;
    Eigen::Array<bool, Eigen::Dynamic, 1> seen_;
};

/// The same for a complex matrix; real and imaginary parts are collected into std::complex for Eigen's
/// kernels.
template <class Scalar>
class dense_complex_lu {
    using complex = std::complex<Scalar>;

  public:
    explicit dense_complex_lu(int n) : re_(n, n), im_(n, n), a_(n, n), b_(n), x_(n), lu_(n) {}

    Scalar* real_entries() { return re_.data(); }
    Scalar* imaginary_entries() { return im_.data(); }

    bool factor() {
        using std::abs;
        if (re_.size() == 0) return true;
        a_.real() = re_;
        a_.imag() = im_;
        lu_.compute(a_);
        for (Eigen::Index i = 0; i < a_.rows(); ++i)
            if (!usable_pivot(Scalar(abs(lu_.matrixLU()(i, i))))) return false;
        return true;
    }

    void solve(Scalar* x, Scalar* y) {
        const Eigen::Index n = b_.size();
        if (n == 0) return;
        for (Eigen::Index i = 0; i < n; ++i) b_[i] = complex(x[i], y[i]);
        x_ = lu_.solve(b_);
        for (Eigen::Index i = 0; i < n; ++i) x[i] = x_[i].real(), y[i] = x_[i].imag();
    }

  private:
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> re_, im_;
    Eigen::Matrix<complex, Eigen::Dynamic, Eigen::Dynamic> a_;
    Eigen::Matrix<complex, Eigen::Dynamic, 1> b_, x_;
    Eigen::PartialPivLU<Eigen::Matrix<complex, Eigen::Dynamic, Eigen::Dynamic>> lu_;
};

}  // namespace stagecraft
