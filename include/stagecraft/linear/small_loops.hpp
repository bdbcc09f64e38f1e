// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <cmath>

// Copies and products of small matrices of fixed size as plain loops. Every expression of Eigen's is a class that the
// compiler makes anew for each size and scalar (10 ms each with g++ 12): a mechanical model over five scalars had 150.
namespace stagecraft::detail {

/// Every entry x.
template <class S, int Rows, int Columns>
void fill(Eigen::Matrix<S, Rows, Columns>& A, const S& x) {
    for (int j = 0; j < Columns; ++j)
        for (int i = 0; i < Rows; ++i) A(i, j) = x;
}

/// N components of y, from the given one on.
template <int N, class S, int Size>
Eigen::Matrix<S, N, 1> part(const Eigen::Matrix<S, Size, 1>& y, int first) {
    Eigen::Matrix<S, N, 1> x;
    for (int i = 0; i < N; ++i) x[i] = y[first + i];
    return x;
}

/// Writes x into y, from component `first` on.
template <class S, int N, int Size>
void put(const Eigen::Matrix<S, N, 1>& x, Eigen::Matrix<S, Size, 1>& y, int first) {
    for (int i = 0; i < N; ++i) y[first + i] = x[i];
}

/// Writes A into J, its first entry at (row, column).
template <class S, int Rows, int Columns, int Size>
void put(const Eigen::Matrix<S, Rows, Columns>& A, Eigen::Matrix<S, Size, Size>& J, int row, int column) {
    for (int j = 0; j < Columns; ++j)
        for (int i = 0; i < Rows; ++i) J(row + i, column + j) = A(i, j);
}

/// (x, y, z, 0, ...) with Size components.
template <int Size, class S, int X, int Y, int Z = 0>
Eigen::Matrix<S, Size, 1> joined(const Eigen::Matrix<S, X, 1>& x, const Eigen::Matrix<S, Y, 1>& y,
                                 const Eigen::Matrix<S, Z, 1>& z = {}) {
    Eigen::Matrix<S, Size, 1> all;
    fill(all, S(0));
    put(x, all, 0);
    put(y, all, X);
    put(z, all, X + Y);
    return all;
}

/// A x.
template <class S, int Rows, int Columns>
requires(Rows > 0) Eigen::Matrix<S, Rows, 1> times(const Eigen::Matrix<S, Rows, Columns>& A,
                                                   const Eigen::Matrix<S, Columns, 1>& x) {
    Eigen::Matrix<S, Rows, 1> r;
    for (int i = 0; i < Rows; ++i) r[i] = A(i, 0) * x[0];
    for (int j = 1; j < Columns; ++j)
        for (int i = 0; i < Rows; ++i) r[i] += A(i, j) * x[j];
    return r;
}

/// The same of an A of any kind whose size is known at run time, a sparse one as well.
template <class Matrix, class Vector>
requires(int(Matrix::RowsAtCompileTime) == Eigen::Dynamic) Vector times(const Matrix& A, const Vector& x) {
    return A * x;
}

/// A B.
template <class S, int Rows, int Inner, int Columns>
Eigen::Matrix<S, Rows, Columns> product(const Eigen::Matrix<S, Rows, Inner>& A,
                                        const Eigen::Matrix<S, Inner, Columns>& B) {
    Eigen::Matrix<S, Rows, Columns> C;
    for (int j = 0; j < Columns; ++j) {
        for (int i = 0; i < Rows; ++i) C(i, j) = A(i, 0) * B(0, j);
        for (int k = 1; k < Inner; ++k)
            for (int i = 0; i < Rows; ++i) C(i, j) += A(i, k) * B(k, j);
    }
    return C;
}

/// r -= A^T x.
template <class S, int Rows, int Columns>
requires(Rows > 0) void subtract_transposed(const Eigen::Matrix<S, Rows, Columns>& A,
                                            const Eigen::Matrix<S, Rows, 1>& x,
                                            Eigen::Matrix<S, Columns, 1>& r) {
    for (int j = 0; j < Columns; ++j)
        for (int i = 0; i < Rows; ++i) r[j] -= A(i, j) * x[i];
}

template <class Matrix, class Vector>
requires(int(Matrix::RowsAtCompileTime) ==
         Eigen::Dynamic) void subtract_transposed(const Matrix& A, const Vector& x, Vector& r) {
    r -= A.transpose() * x;
}

/// The largest |A_ij|; not a number if one of them is not.
template <class S, int Rows, int Columns>
S largest(const Eigen::Matrix<S, Rows, Columns>& A) {
    using std::abs;
    S most(0);
    for (Eigen::Index j = 0; j < A.cols(); ++j)
        for (Eigen::Index i = 0; i < A.rows(); ++i)
            if (const S size = abs(A(i, j)); !(size <= most)) most = size;
    return most;
}

}  // namespace stagecraft::detail
