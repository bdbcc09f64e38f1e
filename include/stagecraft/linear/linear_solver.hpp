// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <concepts>
#include <vector>

#include <stagecraft/linear/block_work.hpp>
#include <stagecraft/linear/linear_solve.hpp>

// What the stages of a method ask of linear algebra: the concept linear_solver, and the concepts of what a solver need not
// have.

namespace stagecraft {

namespace detail {

/// shift M - J by itself, or through its entries, column by column, and factor().
template <class Block, class Mass, class Matrix, class Scalar>
concept factors_real = requires(Block& b, const Mass& M, const Matrix& J, const Scalar& shift) {
    { b.factor_shifted(M, J, shift) } -> std::same_as<bool>;
}
|| requires(Block& b) {
    { b.entries() } -> std::convertible_to<Scalar*>;
    { b.factor() } -> std::same_as<bool>;
};
/// The same of (re + i im) M - J.
template <class Block, class Mass, class Matrix, class Scalar>
concept factors_complex = requires(Block& b, const Mass& M, const Matrix& J, const Scalar& re,
                                   const Scalar& im) {
    { b.factor_shifted(M, J, re, im) } -> std::same_as<bool>;
}
|| requires(Block& b) {
    { b.real_entries() } -> std::convertible_to<Scalar*>;
    { b.imaginary_entries() } -> std::convertible_to<Scalar*>;
    { b.factor() } -> std::same_as<bool>;
};

}  // namespace detail

/// Solvers for the systems of a step, (shift M - J) x = b with real and complex shifts: a type with the members `real` and
/// `complex`, each constructed from the size n, in which n numbers follow each other. Models: dense_blocks, banded_blocks,
/// sparse_blocks, krylov_blocks, one_factor_blocks, petsc_blocks, and yours (problem.linear_solver).
///   - b.factor_shifted(M, J, shift) of a real block, (M, J, re, im) of a complex one: false where the matrix is singular or
///     not finite. Once for many solves. Dense blocks bring their entries and factor() instead.
///   - b.solve(x), b.solve(re, im): in place, with the last factors.
template <class Solvers, class Mass, class Matrix, class Scalar>
concept linear_solver = requires(typename Solvers::real& real, typename Solvers::complex& complex,
                                 Scalar* x) {
    requires std::constructible_from<typename Solvers::real, int>;
    requires std::constructible_from<typename Solvers::complex, int>;
    real.solve(x);
    complex.solve(x, x);
}
&&detail::factors_real<typename Solvers::real, Mass, Matrix, Scalar>&&
    detail::factors_complex<typename Solvers::complex, Mass, Matrix, Scalar>;

// What a solver may have besides.

/// The sign of the determinant, by which growing modes are seen (judge/guards/growth_watch.hpp): b.negative_determinant().
template <class Block>
concept tells_determinant = requires(Block& b) {
    { b.negative_determinant() } -> std::convertible_to<bool>;
};

/// What its systems cost, as the last factors showed it, in the units of block_work: b.work(). The choice of the order and
/// the life of factors follow it; without it the size of the Jacobian is what they go by.
template <class Block>
concept tells_work = requires(const Block& b) {
    b.work().per_stage;
};

/// Solvers that iterate: b.solve_leaving(part, x) may leave that part of a right-hand side, 0 for as little as usual.
template <class Solvers, class Scalar>
concept inexact_blocks = requires(typename Solvers::real& b, Scalar* x, Scalar part) {
    b.solve_leaving(part, x);
};
/// Those whose every solve is an iteration; others say by b.iterates() whether they do, as long as the factors are the same.
template <class Block>
concept may_iterate = requires(const Block& b) {
    { b.iterates() } -> std::convertible_to<bool>;
};
template <class Solvers, class Scalar>
concept iterative_blocks = inexact_blocks<Solvers, Scalar> && !may_iterate<typename Solvers::complex>;

/// The part that a solve leaves as usual: b.usual_part().
template <class Block>
concept tells_usual_part = requires(const Block& b) {
    b.usual_part();
};
/// What its last solve came to; one that failed has left NaN (linear_solve.hpp): b.last_solve().
template <class Block>
concept tells_last_solve = requires(const Block& b) {
    { b.last_solve() } -> std::convertible_to<const linear_solve&>;
};

/// All systems of a step at once, where that costs less than one after the other: Solvers::factor_all(reals, complexes, M, J,
/// shifts) with the shifts of the real ones, then real and imaginary part of each complex one, and
/// Solvers::solve_all(reals, complexes, x, n) with their right-hand sides in that order.
template <class Solvers, class Mass, class Matrix, class Scalar>
concept factors_all = requires(std::vector<typename Solvers::real>& reals,
                               std::vector<typename Solvers::complex>& complexes, const Mass& M,
                               const Matrix& J, const Scalar* shifts) {
    { Solvers::factor_all(reals, complexes, M, J, shifts) } -> std::same_as<bool>;
};
template <class Solvers, class Scalar>
concept solves_all = requires(std::vector<typename Solvers::real>& reals,
                              std::vector<typename Solvers::complex>& complexes, Scalar* x, int n) {
    Solvers::solve_all(reals, complexes, x, n);
};

}  // namespace stagecraft
