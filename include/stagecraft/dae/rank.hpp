// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>

#include <stagecraft/dae/matrix_pool.hpp>

namespace stagecraft::detail {

/// A P = Q R by Householder reflections with column pivoting, stopped at pivots below `zero` times the first
/// one. Plain loops: the matrices are those of a handful of constraints, and Eigen's blocked decompositions
/// cost a program that uses them ten seconds of compilation.
template <class Work>
struct pivoted_qr {
    using scalar = typename Work::scalar;
    typename Work::matrix Q, R;
    typename Work::indices columns;  ///< column k of R belongs to column columns[k] of A
    int rank = 0;

    template <class Matrix>
    pivoted_qr(Work& work, const Matrix& a, const scalar& zero)
        : Q(work.take(a.rows(), a.rows())),
          R(work.take(a.rows(), a.cols())),
          columns(work.take_indices(a.cols())) {
        using std::abs;
        using std::sqrt;
        const int m = static_cast<int>(a.rows()), n = static_cast<int>(a.cols());
        Q.setIdentity();
        R = a;
        for (int j = 0; j < n; ++j) columns[j] = j;
        auto v = work.take(m);
        scalar first(0);
        for (int k = 0; k < m && k < n; ++k) {
            int best = k;
            scalar most(-1);
            for (int j = k; j < n; ++j) {
                scalar sum(0);
                for (int i = k; i < m; ++i) sum += R(i, j) * R(i, j);
                if (sum > most) most = sum, best = j;
            }
            const scalar size = sqrt(most > scalar(0) ? most : scalar(0));
            if (k == 0) first = size;
            if (!(size > zero * first)) return;
            for (int i = 0; i < m; ++i) std::swap(R(i, k), R(i, best));
            std::swap(columns[k], columns[best]);
            // v = x + sign(x_k) |x| e_k, reflection I - 2 v v^T / (v^T v)
            scalar square(0);
            for (int i = k; i < m; ++i) v[i] = R(i, k);
            v[k] += v[k] < scalar(0) ? scalar(-size) : size;
            for (int i = k; i < m; ++i) square += v[i] * v[i];
            for (int j = k; j < n; ++j) {
                scalar sum(0);
                for (int i = k; i < m; ++i) sum += v[i] * R(i, j);
                sum *= 2 / square;
                for (int i = k; i < m; ++i) R(i, j) -= sum * v[i];
            }
            for (int r = 0; r < m; ++r) {
                scalar sum(0);
                for (int i = k; i < m; ++i) sum += v[i] * Q(r, i);
                sum *= 2 / square;
                for (int i = k; i < m; ++i) Q(r, i) -= sum * v[i];
            }
            rank = k + 1;
        }
    }
};

/// a b by plain loops; b is a matrix or a vector.
template <class Scalar, int Max, class A, class B>
auto product(workspace<Scalar, Max>& work, const A& a, const B& b) {
    auto r = [&] {
        if constexpr (B::ColsAtCompileTime == 1)
            return work.take(a.rows());
        else
            return work.take(a.rows(), b.cols());
    }();
    for (Eigen::Index j = 0; j < b.cols(); ++j)
        for (Eigen::Index i = 0; i < a.rows(); ++i) {
            Scalar sum(0);
            for (Eigen::Index k = 0; k < a.cols(); ++k) sum += a(i, k) * b(k, j);
            r(i, j) = sum;
        }
    return r;
}

/// Rank, kernel and solutions of least norm of a matrix A of run-time size, from the decomposition A^T P = Q
/// R: the first `rank` columns of Q span the rows of A, the others its kernel.
template <class Work>
class rank_revealing {
  public:
    using scalar = typename Work::scalar;
    using matrix = typename Work::matrix;
    using vector = typename Work::vector;

    /// Pivots below `zero` times the largest count as zero. The workspace must live as long as this.
    template <class Matrix>
    rank_revealing(Work& work, const Matrix& a, const scalar& zero)
        : work_(work),
          rows_(static_cast<int>(a.rows())),
          across_(work, a.transpose(), zero),
          down_(work, factor(), scalar(0)) {}

    int rank() const { return across_.rank; }
    /// Least-squares solution of least norm.
    template <class Vector>
    vector solve(const Vector& b) const {
        // x = Q1 w, R1^T w = b in the order of the pivots, in the sense of least squares: R1^T = Q' R'.
        const int r = rank(), n = static_cast<int>(across_.Q.rows());
        vector w = work_.take(r), x = work_.take(n);
        x.setZero();
        for (int k = 0; k < r; ++k) {
            w[k] = scalar(0);
            for (int i = 0; i < rows_; ++i) w[k] += down_.Q(i, k) * b[across_.columns[i]];
        }
        for (int k = r - 1; k >= 0; --k) {
            for (int j = k + 1; j < r; ++j) w[k] -= down_.R(k, j) * w[j];
            w[k] /= down_.R(k, k);
        }
        for (int k = 0; k < r; ++k)
            for (int i = 0; i < n; ++i) x[i] += across_.Q(i, down_.columns[k]) * w[k];
        return x;
    }
    /// Orthonormal columns x with A x = 0; unit vectors up to sign where the columns of A are zero.
    matrix kernel() const {
        matrix result = work_.take(across_.Q.rows(), across_.Q.cols() - rank());
        result = across_.Q.rightCols(result.cols());
        return result;
    }

  private:
    /// The first columns of R^T, rows in the order of the pivots.
    matrix factor() const {
        matrix result = work_.take(rows_, across_.rank);
        for (int k = 0; k < across_.rank; ++k)
            for (int i = 0; i < rows_; ++i) result(i, k) = i < k ? scalar(0) : across_.R(k, i);
        return result;
    }
    Work& work_;
    int rows_;
    pivoted_qr<Work> across_, down_;
};

/// The same row space in echelon form: every row has a pivot one where the other rows are zero, so that
/// equations without common unknowns are not combined.
template <class Matrix>
void reduce_rows(Matrix& U, const typename Matrix::Scalar& zero) {
    using std::abs;
    using scalar = typename Matrix::Scalar;
    for (Eigen::Index r = 0; r < U.rows(); ++r) {
        Eigen::Index row = r, column = 0;
        U.bottomRows(U.rows() - r).cwiseAbs().maxCoeff(&row, &column);
        if (row > 0) U.row(r).swap(U.row(r + row));
        U.row(r) /= scalar(U(r, column));
        for (Eigen::Index i = 0; i < U.rows(); ++i) {
            if (i == r) continue;
            const scalar factor = U(i, column);
            for (Eigen::Index j = 0; j < U.cols(); ++j) {
                U(i, j) -= factor * U(r, j);
                if (abs(U(i, j)) <= zero) U(i, j) = scalar(0);
            }
        }
    }
}

/// Divides the rows of m by the largest entry of the rows of `by`; returns the factors.
template <class Scalar, int Max, class Matrix, class By>
auto scale_rows(workspace<Scalar, Max>& work, Matrix& m, const By& by) {
    auto scale = work.take(m.rows());
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
        const Scalar size = by.cols() > 0 ? by.row(i).cwiseAbs().maxCoeff() : Scalar(0);
        scale[i] = size > Scalar(0) ? Scalar(Scalar(1) / size) : Scalar(1);
    }
    for (Eigen::Index i = 0; i < m.rows(); ++i) m.row(i) *= scale[i];
    return scale;
}

/// Entries of modulus at most `zero` become zero.
template <class Matrix>
const Matrix& drop_small(Matrix& m, const typename Matrix::Scalar& zero) {
    using std::abs;
    for (Eigen::Index j = 0; j < m.cols(); ++j)
        for (Eigen::Index i = 0; i < m.rows(); ++i)
            if (abs(m(i, j)) <= zero) m(i, j) = typename Matrix::Scalar(0);
    return m;
}

/// Combinations U of the rows of r_x that do not change in the directions of the columns of N: U r_x N = 0 to
/// the accuracy `zero` relative to the rows.
template <class Scalar, int Max, class Matrix, class Directions>
auto invisible_combinations(workspace<Scalar, Max>& work, const Matrix& r_x, const Directions& N,
                            const Scalar& zero) {
    auto block = product(work, r_x, N);
    const auto scale = scale_rows(work, block, r_x);
    drop_small(block, zero);
    const auto kernel = rank_revealing<workspace<Scalar, Max>>(work, block.transpose(), zero).kernel();
    auto U = work.take(kernel.cols(), kernel.rows());
    U = kernel.transpose();
    if (U.rows() < U.cols()) {
        reduce_rows(U, zero);
        for (Eigen::Index j = 0; j < U.cols(); ++j) U.col(j) *= scale[j];
    }
    return U;
}

/// A matrix with its rows divided by their largest entry (or by that of the rows of another one), decomposed.
/// Changes the matrix given.
template <class Work>
class row_scaled {
  public:
    using vector = typename Work::vector;
    template <class Matrix, class By>
    row_scaled(Work& work, Matrix&& m, const By& by, const typename Work::scalar& zero)
        : work_(work), scale_(scale_rows(work, m, by)), decomposition_(work, drop_small(m, zero), zero) {}
    int rank() const { return decomposition_.rank(); }
    const vector& scale() const { return scale_; }
    /// Least-squares solution of least norm.
    vector solve(const vector& r) const {
        vector scaled = work_.take(r.size());
        scaled = scale_.cwiseProduct(r);
        return decomposition_.solve(scaled);
    }

  private:
    Work& work_;
    vector scale_;
    rank_revealing<Work> decomposition_;
};

}  // namespace stagecraft::detail
