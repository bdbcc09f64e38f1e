// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <type_traits>

namespace stagecraft {

/// L D L^T of a small symmetric positive definite matrix of fixed size N, without pivoting, over any
/// field-like scalar: double, wide floats, dual numbers of automatic differentiation. Only the lower triangle
/// is read. A matrix that is not positive definite is not an error: `pivot` shows it, and a zero pivot makes
/// the solutions non-finite.
template <class Scalar, int N>
class small_ldlt {
  public:
    using matrix = Eigen::Matrix<Scalar, N, N>;
    using vector = Eigen::Matrix<Scalar, N, 1>;

    explicit small_ldlt(const matrix& a) : l_(a) {
        for (int j = 0; j < N; ++j) {
            for (int k = 0; k < j; ++k) {
                if constexpr (std::is_floating_point_v<Scalar>)
                    if (l_(j, k) == Scalar(0)) continue;  // masses of points: nothing couples them
                const Scalar weighted = l_(j, k) * l_(k, k);
                for (int i = j; i < N; ++i) l_(i, j) -= l_(i, k) * weighted;
            }
            inverse_[j] = Scalar(1) / l_(j, j);
            for (int i = j + 1; i < N; ++i) l_(i, j) *= inverse_[j];
        }
    }

    const Scalar& pivot(int j) const { return l_(j, j); }

    vector solve(vector x) const {
        for (int j = 0; j < N; ++j)
            for (int i = j + 1; i < N; ++i) x[i] -= l_(i, j) * x[j];
        for (int j = 0; j < N; ++j) x[j] *= inverse_[j];
        for (int j = N - 1; j >= 0; --j)
            for (int i = j + 1; i < N; ++i) x[j] -= l_(i, j) * x[i];
        return x;
    }

    template <int Columns>
    requires(Columns > 1) Eigen::Matrix<Scalar, N, Columns> solve(const Eigen::Matrix<Scalar, N, Columns>& b)
    const {
        Eigen::Matrix<Scalar, N, Columns> x;
        for (int j = 0; j < Columns; ++j) x.col(j) = solve(vector(b.col(j)));
        return x;
    }

  private:
    matrix l_;        // L below the diagonal, D on it
    vector inverse_;  // of D
};

}  // namespace stagecraft
