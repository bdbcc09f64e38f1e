// SPDX-License-Identifier: BSL-1.0
#include <problems/dense_once.hpp>
#include <problems/sparse_once.hpp>

namespace Eigen {

template void PartialPivLU<MatrixXd>::compute();
template void HouseholderQR<MatrixXd>::computeInPlace();
template RealSchur<MatrixXd>& RealSchur<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
template EigenSolver<MatrixXd>& EigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
template void SparseLU<SparseMatrix<double>>::analyzePattern(const SparseMatrix<double>&);
template void SparseLU<SparseMatrix<double>>::factorize(const SparseMatrix<double>&);
template void SparseLU<SparseMatrix<std::complex<double>>>::analyzePattern(
    const SparseMatrix<std::complex<double>>&);
template void SparseLU<SparseMatrix<std::complex<double>>>::factorize(
    const SparseMatrix<std::complex<double>>&);

}  // namespace Eigen
