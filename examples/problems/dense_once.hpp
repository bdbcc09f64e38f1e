// SPDX-License-Identifier: BSL-1.0
// Decompositions of Eigen's that several programs here need and that each take a second and more to compile: a file
// that includes this one leaves them to eigen_once.cpp.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace Eigen {

extern template void PartialPivLU<MatrixXd>::compute();
extern template void HouseholderQR<MatrixXd>::computeInPlace();
extern template RealSchur<MatrixXd>& RealSchur<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
extern template EigenSolver<MatrixXd>& EigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);

}  // namespace Eigen
