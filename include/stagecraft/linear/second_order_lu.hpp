// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>

#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/coupling.hpp>
#include <stagecraft/linear/dense_blocks.hpp>

namespace stagecraft {

/// Solvers for shift M - J of a system of second order of any size with dense J: m positions q, then R = n -
/// m other components, the first m of them the velocities v with q' = v. q is eliminated from shift q - v =
/// r_q and the R x R matrix shift M_22 - J_22 - J_21 / shift is factored (J_21 / shift in the columns of v),
/// an eighth of the work where R = n/2. m is Positions, or n/2 where that is Eigen::Dynamic.
template <class Scalar, int Positions = Eigen::Dynamic>
struct second_order_lu {
    using vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    /// The same without the structure.
    using whole = dense_blocks<Scalar, Eigen::Dynamic>;

    class real {
      public:
        explicit real(int n) : m_(position_count(n)), rest_(n - m_), lu_(rest_), coupling_(rest_, m_) {}

        /// False if the matrix is singular or not finite.
        template <class Mass, class Matrix>
        bool factor_shifted(const Mass& mass, const Matrix& J, const Scalar& shift) {
            inverse_ = Scalar(1) / shift;
            coupling_.take(J.data() + m_, static_cast<int>(J.rows()));
            Eigen::Map<matrix> a(lu_.entries(), rest_, rest_);
            a = -J.bottomRightCorner(rest_, rest_);
            coupling_.each([&](int i, int j, const Scalar& v) { a(i, j) -= inverse_ * v; });
            for_rest(mass, m_, rest_, [&](int i, int j, const Scalar& value) { a(i, j) += shift * value; });
            return lu_.factor();
        }
        void solve(Scalar* x) {
            Eigen::Map<vector> q(x, m_), r(x + m_, rest_);
            q *= inverse_;
            coupling_.add_product(x, x + m_);
            lu_.solve(x + m_);
            q += inverse_ * r.head(m_);
        }
        /// Sign of the determinant of the whole matrix last factored.
        bool negative_determinant() {
            return lu_.negative_determinant() ^ (m_ % 2 == 1 && inverse_ < Scalar(0));
        }

      private:
        int m_, rest_;
        Scalar inverse_{0};
        typename whole::real lu_;
        coupling<Scalar> coupling_;
    };

    class complex {
      public:
        explicit complex(int n) : m_(position_count(n)), rest_(n - m_), lu_(rest_), coupling_(rest_, m_) {}

        template <class Mass, class Matrix>
        bool factor_shifted(const Mass& mass, const Matrix& J, const Scalar& re, const Scalar& im) {
            reciprocal(re, im, re_, im_);
            coupling_.take(J.data() + m_, static_cast<int>(J.rows()));
            Eigen::Map<matrix> a(lu_.real_entries(), rest_, rest_), b(lu_.imaginary_entries(), rest_, rest_);
            a = -J.bottomRightCorner(rest_, rest_);
            b.setZero();
            coupling_.each([&](int i, int j, const Scalar& v) {
                a(i, j) -= re_ * v;
                b(i, j) = -im_ * v;
            });
            for_rest(mass, m_, rest_, [&](int i, int j, const Scalar& value) {
                a(i, j) += re * value;
                b(i, j) += im * value;
            });
            return lu_.factor();
        }
        void solve(Scalar* x, Scalar* y) {
            divide(x, y);
            Eigen::Map<vector> q(x, m_), p(y, m_), r(x + m_, rest_), s(y + m_, rest_);
            coupling_.add_product(x, x + m_);
            coupling_.add_product(y, y + m_);
            lu_.solve(x + m_, y + m_);
            q += re_ * r.head(m_) - im_ * s.head(m_);
            p += re_ * s.head(m_) + im_ * r.head(m_);
        }

      private:
        /// q := r_q / shift
        void divide(Scalar* x, Scalar* y) const {
            for (int i = 0; i < m_; ++i) {
                const Scalar a = x[i], b = y[i];
                x[i] = re_ * a - im_ * b;
                y[i] = re_ * b + im_ * a;
            }
        }
        int m_, rest_;
        Scalar re_{0}, im_{0};  // of 1 / shift
        typename whole::complex lu_;
        coupling<Scalar> coupling_;
    };

    /// What one matrix costs (linear/block_work.hpp).
    static block_work<Scalar> work(int n) {
        const Scalar m = Scalar(position_count(n)), rest = Scalar(n) - m;
        return {rest * rest * rest / 3 + 4 * rest, rest * rest + rest * m / 2};
    }

  private:
    static int position_count(int n) { return Positions == Eigen::Dynamic ? n / 2 : Positions; }

    /// Calls f(i, j, M_22(i, j)) for the entries of the mass matrix outside the rows and columns of q.
    template <class Mass, class F>
    static void for_rest(const Mass& mass, int m, int rest, F&& f) {
        if constexpr (Mass::identity) {
            for (int i = 0; i < rest; ++i) f(i, i, Scalar(1));
        } else {
            for (const auto& e : mass.entries())
                if (e.row >= m && e.column >= m) f(e.row - m, e.column - m, e.value);
        }
    }
};

/// What serves a system of second order with dense J of fixed or run-time size N: to N = 16 the blocks of a
/// step are reduced and factored side by side (stages/lane_blocks.hpp).
template <class Scalar, int N, int Positions>
struct second_order_blocks : second_order_lu<Scalar, Positions> {};
template <class Scalar, int N, int Positions>
requires(N >= 1 && N <= 16 &&
         dense_blocks<Scalar, N>::built_in) struct second_order_blocks<Scalar, N, Positions>
    : dense_blocks<Scalar, N> {
    static constexpr int positions = Positions == Eigen::Dynamic ? N / 2 : Positions;
};

}  // namespace stagecraft
