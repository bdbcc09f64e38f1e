// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/linear/dense_blocks.hpp>

namespace stagecraft {

/// Solvers for shift M - J of a system of second order of any size, n/2 positions q and as many velocities v
/// with q' = v: q is eliminated from shift q - v = r_q and the matrix shift M_22 - J_22 - J_21 / shift of
/// half the size is factored, an eighth of the work. A `linear_solver` for problems whose size is known at
/// run time, or above 16.
template <class Scalar>
struct second_order_lu {
    class real {
      public:
        explicit real(int n) : m_(n / 2), lu_(n / 2), coupling_(n / 2, n / 2) {}

        template <class Mass, class Matrix>
        bool factor_shifted(const Mass& mass, const Matrix& J, const Scalar& shift) {
            inverse_ = Scalar(1) / shift;
            coupling_ = J.bottomLeftCorner(m_, m_);
            Scalar* a = lu_.entries();
            for (int j = 0; j < m_; ++j)
                for (int i = 0; i < m_; ++i) a[i + j * m_] = -J(m_ + i, m_ + j) - inverse_ * coupling_(i, j);
            for_velocities(mass, m_,
                           [&](int i, int j, const Scalar& value) { a[i + j * m_] += shift * value; });
            return lu_.factor();
        }
        void solve(Scalar* x) {
            Eigen::Map<vector> q(x, m_), r(x + m_, m_);
            q *= inverse_;
            r.noalias() += coupling_ * q;
            lu_.solve(x + m_);
            q += inverse_ * r;
        }

      private:
        int m_;
        Scalar inverse_{0};
        typename dense_blocks<Scalar, Eigen::Dynamic>::real lu_;
        Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> coupling_;
    };

    class complex {
      public:
        explicit complex(int n) : m_(n / 2), lu_(n / 2), coupling_(n / 2, n / 2) {}

        template <class Mass, class Matrix>
        bool factor_shifted(const Mass& mass, const Matrix& J, const Scalar& re, const Scalar& im) {
            const Scalar size = re * re + im * im;
            re_ = re / size;
            im_ = -im / size;
            coupling_ = J.bottomLeftCorner(m_, m_);
            Scalar *a = lu_.real_entries(), *b = lu_.imaginary_entries();
            for (int j = 0; j < m_; ++j)
                for (int i = 0; i < m_; ++i) {
                    a[i + j * m_] = -J(m_ + i, m_ + j) - re_ * coupling_(i, j);
                    b[i + j * m_] = -im_ * coupling_(i, j);
                }
            for_velocities(mass, m_, [&](int i, int j, const Scalar& value) {
                a[i + j * m_] += re * value;
                b[i + j * m_] += im * value;
            });
            return lu_.factor();
        }
        void solve(Scalar* x, Scalar* y) {
            Eigen::Map<vector> q(x, m_), p(y, m_), r(x + m_, m_), s(y + m_, m_);
            for (int i = 0; i < m_; ++i) {
                const Scalar a = q[i];
                q[i] = re_ * a - im_ * p[i];
                p[i] = re_ * p[i] + im_ * a;
            }
            r.noalias() += coupling_ * q;
            s.noalias() += coupling_ * p;
            lu_.solve(x + m_, y + m_);
            q += re_ * r - im_ * s;
            p += re_ * s + im_ * r;
        }

      private:
        int m_;
        Scalar re_{0}, im_{0};
        typename dense_blocks<Scalar, Eigen::Dynamic>::complex lu_;
        Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> coupling_;
    };

  private:
    using vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    /// Calls f(i, j, M_22(i, j)) for the entries of the mass matrix in the rows and columns of v.
    template <class Mass, class F>
    static void for_velocities(const Mass& mass, int m, F&& f) {
        if constexpr (Mass::identity) {
            for (int i = 0; i < m; ++i) f(i, i, Scalar(1));
        } else {
            for (const auto& e : mass.entries())
                if (e.row >= m && e.column >= m) f(e.row - m, e.column - m, e.value);
        }
    }
};

}  // namespace stagecraft
