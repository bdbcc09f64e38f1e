// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <stagecraft/linear/almost_block_diagonal.hpp>

namespace stagecraft {

/// Elimination of the first `pivots` columns of a panel by Householder reflections: stable whatever the rows
/// carried on mean (structured orthogonal elimination, Wright 1992), where row pivoting can fail completely.
struct orthogonal_elimination {
    template <class Matrix, class Scalar>
    static void factor(Matrix& a, int pivots, Scalar* tau, int*) {
        using std::abs;
        using std::sqrt;
        const int rows = static_cast<int>(a.rows()), columns = static_cast<int>(a.cols());
        for (int k = 0; k < pivots; ++k) {
            Scalar largest(0), sum(0);
            for (int i = k; i < rows; ++i)
                if (abs(a(i, k)) > largest) largest = abs(a(i, k));
            tau[k] = Scalar(0);
            if (!usable_pivot(largest)) continue;
            for (int i = k; i < rows; ++i) {
                const Scalar v = a(i, k) / largest;
                sum += v * v;
            }
            const Scalar norm = largest * sqrt(sum), head = a(k, k);
            const Scalar end = head > Scalar(0) ? Scalar(-norm) : norm;
            if (end == head) continue;
            tau[k] = (end - head) / end;
            for (int i = k + 1; i < rows; ++i) a(i, k) /= head - end;
            a(k, k) = end;
            for (int j = k + 1; j < columns; ++j) {
                Scalar dot = a(k, j);
                for (int i = k + 1; i < rows; ++i) dot += a(i, k) * a(i, j);
                dot *= tau[k];
                a(k, j) -= dot;
                for (int i = k + 1; i < rows; ++i) a(i, j) -= a(i, k) * dot;
            }
        }
    }
    template <class Matrix, class Scalar>
    static void apply(const Matrix& a, int pivots, const Scalar* tau, const int*, Scalar* x) {
        for (int k = 0; k < pivots; ++k) reflect(a, k, tau[k], x);
    }
    template <class Matrix, class Scalar>
    static void apply_transposed(const Matrix& a, int pivots, const Scalar* tau, const int*, Scalar* x) {
        for (int k = pivots - 1; k >= 0; --k) reflect(a, k, tau[k], x);
    }

  private:
    template <class Matrix, class Scalar>
    static void reflect(const Matrix& a, int k, const Scalar& tau, Scalar* x) {
        const int rows = static_cast<int>(a.rows());
        Scalar dot = x[k];
        for (int i = k + 1; i < rows; ++i) dot += a(i, k) * x[i];
        dot *= tau;
        x[k] -= dot;
        for (int i = k + 1; i < rows; ++i) x[i] -= a(i, k) * dot;
    }
};

/// Blocks A_i y_i + B_i y_{i+1} + C_i p = g_i, i = 0 ... L - 1, closed by n + n_p conditions that couple y_0,
/// y_L and p: y_0 and p are the border of a chain that begins with y_1.
template <class Scalar, int N>
using cyclic_blocks = block_chain<Scalar, N, orthogonal_elimination>;

}  // namespace stagecraft
