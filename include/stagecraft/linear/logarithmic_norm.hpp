// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace stagecraft {

/// The logarithmic norm mu(A) = lim_{h -> 0+} (|I + hA| - 1)/h of a square matrix for the three usual norms
/// (Hairer-Norsett-Wanner I, Theorem I.10.5). mu < 0 in one of them makes y' = A y contractive in that norm;
/// the three may have different signs.
struct logarithmic_norms {
    double euclidean;  ///< largest eigenvalue of (A + A^T)/2
    double one;        ///< max over columns of a_jj + sum of |a_ij|, i != j
    double infinity;   ///< max over rows of a_ii + sum of |a_ij|, j != i
};

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

}  // namespace stagecraft
