// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>

namespace stagecraft::detail {

/// Matrices and vectors of run-time size with at most Max rows and columns, which then need no heap; Max may
/// be Eigen::Dynamic.
template <class Scalar, int Max>
using bounded_matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Max, Max>;
template <class Scalar, int Max>
using bounded_vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, Eigen::ColMajor, Max, 1>;
/// The vectors that go with a matrix type.
template <class Matrix, class Scalar = typename Matrix::Scalar>
using vector_for = bounded_vector<Scalar, Matrix::MaxRowsAtCompileTime>;

/// A P = Q R by Householder reflections with column pivoting, stopped at pivots below `zero` times the first
/// one. Plain loops: the matrices are those of a handful of constraints, and Eigen's blocked decompositions
/// cost a program that uses them ten seconds of compilation.
template <class Matrix>
struct pivoted_qr {
    using scalar = typename Matrix::Scalar;
    Matrix Q, R;
    vector_for<Matrix, int> columns;  ///< column k of R belongs to column columns[k] of A
    int rank = 0;

    pivoted_qr(const Matrix& a, const scalar& zero)
        : Q(Matrix::Identity(a.rows(), a.rows())), R(a), columns(a.cols()) {
        using std::abs;
        using std::sqrt;
        const int m = static_cast<int>(a.rows()), n = static_cast<int>(a.cols());
        for (int j = 0; j < n; ++j) columns[j] = j;
        vector_for<Matrix> v(m);
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

/// a b by plain loops.
template <class A, class B>
auto product(const A& a, const B& b) {
    using scalar = typename A::Scalar;
    Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, A::MaxRowsAtCompileTime,
                  B::MaxColsAtCompileTime>
        r(a.rows(), b.cols());
    for (Eigen::Index j = 0; j < r.cols(); ++j)
        for (Eigen::Index i = 0; i < r.rows(); ++i) {
            scalar sum(0);
            for (Eigen::Index k = 0; k < a.cols(); ++k) sum += a(i, k) * b(k, j);
            r(i, j) = sum;
        }
    return r;
}

/// What the tools for constraints ask of a matrix A of run-time size: rank, kernel, solution of least norm.
/// From the decomposition A^T P = Q R: the rank columns of Q span the rows of A, the others its kernel.
template <class Matrix>
class rank_revealing {
  public:
    using scalar = typename Matrix::Scalar;
    using vector = vector_for<Matrix>;

    rank_revealing() : rank_revealing(Matrix(0, 0), scalar(0)) {}
    /// Pivots below `zero` times the largest count as zero.
    rank_revealing(const Matrix& a, const scalar& zero)
        : rows_(static_cast<int>(a.rows())),
          across_(a.transpose(), zero),
          down_(factor(across_, rows_), scalar(0)) {}

    int rank() const { return across_.rank; }
    /// Least-squares solution of least norm.
    vector solve(const vector& b) const {
        // x = Q1 w, R1^T w = b in the order of the pivots, in the sense of least squares: R1^T = Q' R'.
        const int r = rank(), n = static_cast<int>(across_.Q.rows());
        vector w(r), x = vector::Zero(n);
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
    Matrix kernel() const { return across_.Q.rightCols(across_.Q.cols() - rank()); }

  private:
    /// The first columns of R^T, rows in the order of the pivots.
    static Matrix factor(const pivoted_qr<Matrix>& qr, int rows) {
        Matrix result(rows, qr.rank);
        for (int k = 0; k < qr.rank; ++k)
            for (int i = 0; i < rows; ++i) result(i, k) = i < k ? scalar(0) : qr.R(k, i);
        return result;
    }
    int rows_;
    pivoted_qr<Matrix> across_, down_;
};

/// The same row space in echelon form: every row has a pivot one where the other rows are zero, so that
/// combinations of equations without common members come out one by one.
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
template <class Matrix>
vector_for<Matrix> scale_rows(Matrix& m, const Matrix& by) {
    using scalar = typename Matrix::Scalar;
    vector_for<Matrix> scale(m.rows());
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
        const scalar size = by.cols() > 0 ? by.row(i).cwiseAbs().maxCoeff() : scalar(0);
        scale[i] = size > scalar(0) ? scalar(scalar(1) / size) : scalar(1);
        m.row(i) *= scale[i];
    }
    return scale;
}

/// Entries of modulus at most `zero` become zero.
template <class Matrix>
void drop_small(Matrix& m, const typename Matrix::Scalar& zero) {
    using std::abs;
    for (Eigen::Index j = 0; j < m.cols(); ++j)
        for (Eigen::Index i = 0; i < m.rows(); ++i)
            if (abs(m(i, j)) <= zero) m(i, j) = typename Matrix::Scalar(0);
}

/// Combinations U of the rows of r_x that the directions in the columns of N do not change: U r_x N = 0 to
/// the accuracy `zero` relative to the rows.
template <class Matrix>
Matrix invisible_combinations(const Matrix& r_x, const Matrix& N, const typename Matrix::Scalar& zero) {
    Matrix block = product(r_x, N);
    const auto scale = scale_rows(block, r_x);
    drop_small(block, zero);
    const Matrix transposed = block.transpose();
    Matrix U = rank_revealing<Matrix>(transposed, zero).kernel().transpose();
    if (U.rows() < U.cols()) {
        reduce_rows(U, zero);
        for (Eigen::Index j = 0; j < U.cols(); ++j) U.col(j) *= scale[j];
    }
    return U;
}

/// A matrix with its rows divided by their largest entry (or by that of the rows of another one), decomposed.
template <class Matrix>
class row_scaled {
  public:
    using scalar = typename Matrix::Scalar;
    using vector = vector_for<Matrix>;
    row_scaled(Matrix m, const Matrix& by, const scalar& zero) : scale_(scale_rows(m, by)) {
        drop_small(m, zero);
        decomposition_ = rank_revealing<Matrix>(m, zero);
    }
    int rank() const { return decomposition_.rank(); }
    const vector& scale() const { return scale_; }
    /// Least-squares solution of least norm.
    vector solve(const vector& r) const { return decomposition_.solve(vector(scale_.cwiseProduct(r))); }

  private:
    vector scale_;
    rank_revealing<Matrix> decomposition_;
};

}  // namespace stagecraft::detail
