// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <type_traits>

#include <stagecraft/linear/dense_lu.hpp>
#include <stagecraft/linear/linear_solver.hpp>
#include <stagecraft/linear/mass.hpp>
#include <stagecraft/linear/small_inverse.hpp>
#include <stagecraft/linear/split_lu.hpp>

namespace stagecraft {

/// The linear solvers for shift * M - J with dense J, chosen by size and scalar: explicit inverse to n = 4,
/// LU with compile-time loops to n = 16 and for wide scalars, blocked LU else. A model of linear_solver.
template <class Scalar, int N>
struct dense_blocks {
    static constexpr bool built_in = std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>;
    using real = std::conditional_t<
        (N >= 1 && N <= 4), small_inverse<Scalar, (N >= 1 ? N : 1)>,
        std::conditional_t<(N >= 0 && N <= 16) || !built_in, split_lu<Scalar, N>, dense_lu<Scalar>>>;
    using complex =
        std::conditional_t<(N >= 1 && N <= 4), small_complex_inverse<Scalar, (N >= 1 ? N : 1)>,
                           std::conditional_t<(N >= 0 && N <= 16) || !built_in, split_complex_lu<Scalar, N>,
                                              dense_complex_lu<Scalar>>>;
};

/// How many position components of a system of second order the lanes of such blocks eliminate.
template <class Blocks>
inline constexpr int positions_of = [] {
    if constexpr (requires { Blocks::positions; })
        return static_cast<int>(Blocks::positions);
    else
        return 0;
}();

/// The solver for a matrix of the full size without the structure q' = v, such as M alone.
template <class Blocks>
struct unstructured {
    using type = Blocks;
};
template <class Blocks>
requires requires { typename Blocks::whole; }
struct unstructured<Blocks> {
    using type = typename Blocks::whole;
};

/// Factors shift M - J in a block; false if singular or not finite.
template <class Block, class Mass, class Matrix, class Scalar>
bool factor_shifted(Block& block, const Mass& mass, const Matrix& J, const Scalar& shift) {
    if constexpr (requires { block.factor_shifted(mass, J, shift); }) {
        return block.factor_shifted(mass, J, shift);
    } else {
        const int n = static_cast<int>(J.rows());
        Scalar* a = block.entries();
        const Scalar* j = J.data();
        using entries = Eigen::Array<Scalar, Eigen::Dynamic, 1>;
        Eigen::Map<entries>(a, n * n) = -Eigen::Map<const entries>(j, n * n);
        add_mass(mass, shift, a, n);
        return block.factor();
    }
}

/// Factors (re + i im) M - J in the same way.
template <class Block, class Mass, class Matrix, class Scalar>
bool factor_shifted(Block& block, const Mass& mass, const Matrix& J, const Scalar& re, const Scalar& im) {
    if constexpr (requires { block.factor_shifted(mass, J, re, im); }) {
        return block.factor_shifted(mass, J, re, im);
    } else {
        const int n = static_cast<int>(J.rows());
        Scalar *a = block.real_entries(), *b = block.imaginary_entries();
        const Scalar* j = J.data();
        using entries = Eigen::Array<Scalar, Eigen::Dynamic, 1>;
        Eigen::Map<entries>(a, n * n) = -Eigen::Map<const entries>(j, n * n);
        Eigen::Map<entries>(b, n * n).setZero();
        add_mass(mass, re, a, n);
        add_mass(mass, im, b, n);
        return block.factor();
    }
}

/// The solvers a Jacobian matrix type is served by, unless the problem names its own: dense ones here, those
/// of other structures beside their solvers, none where those are not included.
template <class Matrix>
struct default_blocks {};
template <class Matrix>
requires std::is_base_of_v<Eigen::MatrixBase<Matrix>, Matrix>
struct default_blocks<Matrix> {
    using type = dense_blocks<typename Matrix::Scalar, Matrix::RowsAtCompileTime>;
};

}  // namespace stagecraft
