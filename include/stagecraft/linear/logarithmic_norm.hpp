// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

namespace stagecraft {

/// The logarithmic norm mu(A) = lim_{h -> 0+} (|I + hA| - 1)/h of a square matrix for the three usual norms
/// (Hairer-Norsett-Wanner I, Theorem I.10.5). mu < 0 in one of them makes y' = A y contractive in that norm;
/// the three may have different signs.
struct logarithmic_norms {
    double euclidean;  ///< largest eigenvalue of (A + A^T)/2
    double one;        ///< max over columns of a_jj + sum of |a_ij|, i != j
    double infinity;   ///< max over rows of a_ii + sum of |a_ij|, j != i
};

/// All three of a real square matrix. The Euclidean one takes the eigenvalues of an n x n symmetric matrix, O(n^3).
template <class Derived>
logarithmic_norms logarithmic_norm(const Eigen::MatrixBase<Derived>& a) {
    using matrix = typename Derived::PlainObject;
    const matrix A = a, symmetric = (A + A.transpose()) / 2;
    logarithmic_norms mu{};
    mu.euclidean =
        Eigen::SelfAdjointEigenSolver<matrix>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
    const auto diagonal = A.diagonal().array();
    const matrix off = A.cwiseAbs();
    mu.one = (off.colwise().sum().transpose().array() - diagonal.abs() + diagonal).maxCoeff();
    mu.infinity = (off.rowwise().sum().array() - diagonal.abs() + diagonal).maxCoeff();
    return mu;
}

/// The logarithmic norm in the norm sqrt(x^T G x): the largest mu with det((G A + A^T G)/2 - mu G) = 0, so
/// that <A x, x> <= mu <x, x> with <x, y> = x^T G y. G symmetric positive definite, else
/// std::invalid_argument. Its upper triangle is read only to be compared with the lower one.
template <class DerivedA, class DerivedG>
double logarithmic_norm(const Eigen::MatrixBase<DerivedA>& A, const Eigen::MatrixBase<DerivedG>& G) {
    using matrix = typename DerivedA::PlainObject;
    if (A.rows() != A.cols() || G.rows() != A.rows() || G.cols() != A.cols())
        throw std::invalid_argument("logarithmic_norm: A and G must be square and of the same size");
    if (!(G - G.transpose()).isZero(0)) throw std::invalid_argument("logarithmic_norm: G must be symmetric");
    const matrix GA = G * A, S = (GA + GA.transpose()) / 2;
    if (Eigen::LLT<matrix>(G).info() != Eigen::Success)
        throw std::invalid_argument("logarithmic_norm: G must be positive definite");
    return Eigen::GeneralizedSelfAdjointEigenSolver<matrix>(S, G, Eigen::EigenvaluesOnly | Eigen::Ax_lBx)
        .eigenvalues()
        .maxCoeff();
}

}  // namespace stagecraft
